#include "cli/tying_text.h"

#include "cli/json_text.h"
#include "cli/knot_print.h"
#include "cli/text_pieces.h"
#include "robot/input/knot_move_text.h"

namespace tact::cli {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::RopeEnd;

std::string Segment(const Move& move, size_t k) { return "segment " + std::to_string(move.segments[k]); }
const char* Height(const Move& move) { return move.attr % 2 == 1 ? "over" : "under"; }
const char* End(const Move& move) {
  return move.end == RopeEnd::kSelective ? "the selective end" : "the other end";
}

std::string Steps(size_t count) { return std::to_string(count) + (count == 1 ? " step" : " steps"); }

}  // namespace

std::string MoveInWords(const Move& move) {
  const bool add = move.direction == MoveDirection::kAdd;
  switch (move.kind) {
    case MoveKind::kR1:
      return (add ? "a loop at " : "the loop goes at ") + Segment(move, 0);
    case MoveKind::kR2: {
      const std::string itself = move.segments[0] == move.segments[1] ? "itself" : Segment(move, 1);
      return Segment(move, 0) + (add ? " slides " : " slides back from ") + Height(move) + " " + itself;
    }
    case MoveKind::kR3:
      return Segment(move, 0) + " passes over where " + Segment(move, 1) + " crosses " + Segment(move, 2);
    case MoveKind::kCross:
      return std::string(End(move)) + (add ? " crosses " : " goes back from ") + Height(move) + " " +
             Segment(move, 0);
  }
  return "";
}

std::string TyingToJson(const knot::Tying& tying) {
  std::string text =
      "{\"steps\":" + (tying.found ? std::to_string(tying.steps.size()) : "null") +
      ",\"proved_shortest\":" + (tying.proved_shortest() ? "true" : "false") +
      ",\"excluded_below\":" + (tying.impossible.empty() ? std::to_string(tying.excluded_below) : "null");
  if (!tying.impossible.empty()) text += ",\"impossible\":" + JsonString(tying.impossible);
  return text + ",\"sequence\":[" +
         Join(tying.steps, ",",
              [](const knot::TyingStep& step) {
                return "{\"move\":" + input::MoveToJson({step.move}) +
                       ",\"p_data\":" + step.reached.ToJson() + "}";
              }) +
         "]}\n";
}

std::string TyingSummary(const knot::Tying& tying) {
  if (!tying.impossible.empty()) return "No sequence ties it: " + tying.impossible;
  if (!tying.found)
    return "Nothing shorter than " + Steps(static_cast<size_t>(tying.excluded_below)) + " ties it";
  if (tying.proved_shortest()) return Steps(tying.steps.size()) + ", proved shortest";
  return Steps(tying.steps.size()) + ", the shortest found; fewer than " +
         std::to_string(tying.excluded_below) + " are excluded";
}

std::string TyingToText(const knot::Tying& tying) {
  std::string text;
  for (size_t k = 0; k < tying.steps.size(); ++k) {
    const std::string words = MoveInWords(tying.steps[k].move);
    constexpr size_t kWidth = 44;
    text += (k < 9 ? " " : "") + std::to_string(k + 1) + "  " + words +
            std::string(words.size() < kWidth ? kWidth - words.size() : 1, ' ') + "  " +
            TwoRows(tying.steps[k].reached) + "\n";
  }
  return text + TyingSummary(tying) + ".\n";
}

}  // namespace tact::cli
