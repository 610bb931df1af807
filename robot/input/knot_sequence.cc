#include "robot/input/knot_sequence.h"

#include <algorithm>

#include "robot/input/knot_text.h"

namespace tact::input {
namespace {

// A curve among the arguments, in order.
struct PlacedCurve {
  const SourceText* text;
  CurveText curve;
  size_t knot;  // its index in the sequence
};

// An object that ends on its line: one a line. Otherwise it is one on many lines.
bool HoldsJsonLines(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] != '{') return false;
  const std::string_view line = text.substr(first, text.find('\n', first) - first);
  return line[line.find_last_not_of(" \t\r")] == '}' && line.find('"') != std::string_view::npos;
}

void ReadLines(const SourceText& text, size_t argument, std::vector<ReadKnot>& knots) {
  size_t line = text.first_line;
  for (size_t at = 0; at < text.text.size(); ++line) {
    const size_t end = std::min(text.text.find('\n', at), text.text.size());
    const std::string_view row = text.text.substr(at, end - at);
    at = end + 1;
    if (row.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    knots.push_back(
        {ParsePData(row, text.source, line), text.source + ":" + std::to_string(line) + ":1", argument});
  }
}

}  // namespace

KnotSequence ReadKnotSequence(const std::vector<std::string>& arguments, const CurveView& view) {
  std::vector<NamedText> named;
  std::vector<SourceText> texts;
  for (const std::string& argument : arguments) named.push_back(FindKnotText(argument));
  for (const NamedText& text : named) texts.push_back({text.text, text.source, 1});
  KnotSequence sequence;
  std::vector<PlacedCurve> placed;
  for (size_t i = 0; i < texts.size(); ++i) {
    const SourceText& text = texts[i];
    if (LooksLikeCurve(text)) {
      for (CurveText& curve : ParseCurves(text)) {
        placed.push_back({&text, std::move(curve), sequence.knots.size()});
        sequence.knots.push_back({{}, text.source + ":1:1", i});
      }
    } else if (HoldsJsonLines(text.text)) {
      ReadLines(text, i, sequence.knots);
    } else {
      sequence.knots.push_back({ParsePData(text.text, text.source), text.source + ":1:1", i});
    }
  }
  if (placed.empty()) return sequence;
  std::vector<knot::Curve> curves;
  for (const PlacedCurve& curve : placed) curves.push_back(curve.curve.points);
  auto projected = view ? knot::ProjectCurves(curves, *view) : knot::ProjectCurvesFromBestView(curves);
  if (const auto* faulty = std::get_if<knot::FaultyCurve>(&projected)) {
    const PlacedCurve& curve = placed[faulty->index];
    FailAtFault(*curve.text, curve.curve, faulty->fault, view);
  }
  auto& chosen = std::get<knot::ProjectedCurves>(projected);
  for (size_t i = 0; i < placed.size(); ++i) sequence.knots[placed[i].knot].p = chosen.projections[i].p;
  if (!view) sequence.chosen = std::move(chosen);
  return sequence;
}

}  // namespace tact::input
