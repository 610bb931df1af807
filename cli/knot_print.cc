#include "cli/knot_print.h"

#include "cli/text_pieces.h"
#include "robot/input/knot_move_text.h"

namespace tact::cli {
namespace {

std::string RowText(const std::vector<int>& row) {
  return Join(row, " ", [](int number) { return std::to_string(number); });
}

}  // namespace

std::string Counted(int count, const std::string& thing) {
  return std::to_string(count) + " " + thing + (count == 1 ? "" : "s");
}

std::string TwoRows(const knot::PData& p) {
  if (p.columns() == 0) return "/";
  return RowText(p.SigmaRow()) + " / " + RowText(p.AttrRow());
}

std::string ThreeRows(const knot::PData& p) {
  if (p.columns() == 0) return "/\n";
  std::string rows[3];
  const auto add = [](std::string& row, int number, size_t width) {
    const std::string text = std::to_string(number);
    if (!row.empty()) row += ' ';
    row.append(width - text.size(), ' ');
    row += text;
  };
  const size_t width = std::to_string(p.columns()).size();
  for (int i = 1; i <= p.columns(); ++i) {
    add(rows[0], i, width);
    add(rows[1], p.sigma(i), width);
    add(rows[2], p.attr(i), width);
  }
  return rows[0] + "\n" + rows[1] + "\n" + rows[2] + "\n";
}

std::string AttributeText(int attr) {
  return std::to_string(attr) + (attr % 2 == 1 ? " over/" : " under/") + (attr > 2 ? "+" : "-");
}

std::string DartText(knot::Dart d) { return (d.forward ? "+" : "-") + std::to_string(d.segment); }

std::string MoveText(const knot::Explanation& explanation) {
  using knot::MoveKind;
  const knot::Move& move = explanation.move;
  const auto segment = [&](size_t i) { return std::to_string(move.segments[i]); };
  std::string text =
      std::string(input::NameOf(move.kind)) + " " + std::string(input::NameOf(move.direction)) + ": ";
  switch (move.kind) {
    case MoveKind::kR1:
      text += "segment " + segment(0);
      break;
    case MoveKind::kR2:
      text += "segments " + segment(0) + " and " + segment(1) + ", " + (move.opposite ? "opposite" : "same") +
              " order";
      break;
    case MoveKind::kR3:
      text += "segment " + segment(0) + " over " + segment(1) + " over " + segment(2);
      break;
    case MoveKind::kCross:
      text += std::string(input::NameOf(move.end)) + " end, segment " + segment(0);
      break;
  }
  if (move.kind != MoveKind::kR3) text += ", attribute " + AttributeText(move.attr);
  return text + (explanation.swapped ? "; then the other end is the selective one" : "");
}

}  // namespace tact::cli
