#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "robot/input/knot_move_text.h"
#include "robot/input/knot_text.h"
#include "robot/recognition/knot_recognition.h"

namespace tact::cli {
namespace {

using knot::PData;
using recognition::EndRead;

void AddPData(PData p, const std::string& where, std::vector<PData>& sequence) {
  if (const auto handle = input::FindHandle(p)) throw InputError(where + ": " + *handle);
  sequence.push_back(std::move(p));
}

// A text whose lines are JSON objects holds a P-data a line; any other text holds one.
void ReadSequence(const std::string& argument, std::vector<PData>& sequence) {
  const input::NamedText named = input::FindKnotText(argument);
  const size_t first = named.text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || named.text[first] != '{')
    return AddPData(input::ParsePData(named.text, named.source), named.source, sequence);
  size_t line = 0;
  for (size_t at = 0; at < named.text.size();) {
    const size_t end = std::min(named.text.find('\n', at), named.text.size());
    const std::string text = named.text.substr(at, end - at);
    at = end + 1;
    ++line;
    if (text.find_first_not_of(" \t\r") == std::string::npos) continue;
    AddPData(input::ParsePData(text, named.source, line), named.source + ":" + std::to_string(line),
             sequence);
  }
}

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
  std::vector<PData> sequence;
  for (const std::string& argument : options.inputs) ReadSequence(argument, sequence);
  const auto recognized = recognition::RecognizeKnot(sequence);
  Output output;
  output << (options.json ? ToJson(sequence, recognized) : ToText(sequence, recognized));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
