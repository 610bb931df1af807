#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "robot/input/knot_move_text.h"
#include "robot/recognition/knot_recognition.h"

namespace tact::cli {
namespace {

using knot::PData;
using recognition::EndRead;

const char* NameOf(EndRead end) {
  return end == EndRead::kSwapped ? "swapped" : end == EndRead::kEither ? "either" : "as given";
}

std::string ToJson(const std::vector<PData>& sequence, const recognition::KnotRecognition& recognized) {
  std::string json = "{\"projections\":[";
  for (size_t t = 0; t < sequence.size(); ++t) {
    json += (t > 0 ? "," : "") + std::string("{\"p_data\":") + sequence[t].ToJson() +
            ",\"selective_end\":\"" + NameOf(recognized.ends[t]) + "\"}";
  }
  json += "],\"transitions\":[";
  for (size_t t = 0; t < recognized.transitions.size(); ++t) {
    json += (t > 0 ? "," : "") + std::string("{\"from\":") + std::to_string(t + 1) +
            ",\"to\":" + std::to_string(t + 2) + ",\"moves\":[" +
            Join(recognized.transitions[t], ",", [](const knot::Move& m) { return input::MoveToJson({m}); }) +
            "]}";
  }
  return json + "]}\n";
}

std::string ToText(const std::vector<PData>& sequence, const recognition::KnotRecognition& recognized) {
  std::string text;
  for (size_t t = 0; t < sequence.size(); ++t) {
    if (t > 0) {
      const auto& moves = recognized.transitions[t - 1];
      if (moves.empty()) text += "   no single move leads there\n";
      for (const knot::Move& move : moves)
        text += (&move == &moves.front() ? "   " : "   or ") + MoveText({move}) + "\n";
    }
    text += std::to_string(t + 1) + ": " + Counted(sequence[t].crossings(), "intersection") + ", " +
            TwoRows(sequence[t]);
    if (recognized.ends[t] == EndRead::kSwapped) text += "; read off from the other end";
    if (recognized.ends[t] == EndRead::kEither) text += "; the same from either end";
    text += "\n";
  }
  return text;
}

}  // namespace

ExitStatus RunKnotRecognize(const KnotOptions& options) {
  const std::vector<PData> sequence = ReadPlanarKnotSequence(options);
  const auto recognized = recognition::RecognizeKnot(sequence);
  Output output;
  output << (options.json ? ToJson(sequence, recognized) : ToText(sequence, recognized));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
