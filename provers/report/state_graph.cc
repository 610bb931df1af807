#include "provers/report/state_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "algebra/error.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr double kWidth = 118, kApart = 40, kHeight = 44,
                 kMargin = 12;  // of a state, between, its height, around all
constexpr double kRise = 26;    // of an arc, a state that it passes

double Middle(size_t state) { return kMargin + static_cast<double>(state) * (kWidth + kApart) + kWidth / 2; }

// How high arcs of a side rise at most.
double Room(const std::vector<StateEdge>& edges, bool above) {
  size_t farthest = 0;
  for (const StateEdge& edge : edges) {
    if ((edge.link == StateLink::kSeen) == above)
      farthest = std::max(farthest, edge.from > edge.to ? edge.from - edge.to : edge.to - edge.from);
  }
  return kRise * static_cast<double>(farthest);
}

// A quarter aside of the states' middles, so that neighbours' arcs do not meet.
std::string Arc(const StateEdge& edge, double top) {
  const bool seen = edge.link == StateLink::kSeen, onward = edge.to > edge.from;
  const double aside = onward ? kWidth / 4 : -kWidth / 4;
  const double x1 = Middle(edge.from) + aside, x2 = Middle(edge.to) - aside;
  const double y = seen ? top : top + kHeight, sign = seen ? -1 : 1;
  const auto passed = static_cast<double>(onward ? edge.to - edge.from : edge.from - edge.to);
  const double control = y + sign * kRise * passed * 4 / 3, peak = y + sign * kRise * passed;
  const char* colour = edge.link == StateLink::kRejected ? "#b91c1c" : seen ? "#1d4ed8" : "#8a867d";
  std::string svg = fmt::format(
      "<path d=\"M{:.1f} {:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" stroke=\"{}\" "
      "stroke-width=\"{}\"{}{}/>\n",
      x1, y, x1, control, x2, control, x2, y, colour, seen ? 2.5 : 1.2,
      edge.link == StateLink::kRejected ? " stroke-dasharray=\"3 3\"" : "",
      seen ? " marker-end=\"url(#seen)\"" : "");
  if (edge.link == StateLink::kRejected) {
    const double x = (x1 + x2) / 2;
    svg += fmt::format("<path d=\"M{:.1f} {:.1f}l10 10m0 -10l-10 10\" stroke=\"{}\" stroke-width=\"2.5\"/>\n",
                       x - 5, peak - 5, colour);
  }
  return svg;
}

std::string Box(const std::string& name, size_t state, double top) {
  const double x = Middle(state);
  const size_t line = name.find('\n');
  std::string svg = fmt::format(
      "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" rx=\"6\" fill=\"#fffefb\" "
      "stroke=\"#2b2a27\"/>\n",
      x - kWidth / 2, top, kWidth, kHeight);
  const auto text = [&](const std::string& words, double y, const char* more) {
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\" {}>{}</text>\n", x, y, more,
                       Escape(words));
  };
  text(name.substr(0, line), top + (line == name.npos ? 27 : 19), "font-weight=\"600\"");
  if (line != name.npos) text(name.substr(line + 1), top + 35, "font-size=\"10\"");
  return svg;
}

}  // namespace

std::string DrawStateGraph(const std::vector<std::string>& states, const std::vector<StateEdge>& edges) {
  for (const StateEdge& edge : edges) {
    if (edge.from >= states.size() || edge.to >= states.size() || edge.from == edge.to)
      throw PreconditionError("DrawStateGraph: an edge that ends nowhere, or where it begins");
  }
  const double top = kMargin + Room(edges, true) + 8,
               height = top + kHeight + Room(edges, false) + kMargin + 8;
  const double width = Middle(states.size()) - kWidth / 2 - kApart + kMargin;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" font-family=\"system-ui, "
      "sans-serif\" "
      "font-size=\"12\" fill=\"#2b2a27\">\n<defs><marker id=\"seen\" viewBox=\"0 0 8 8\" refX=\"6\" "
      "refY=\"4\" "
      "markerWidth=\"5\" markerHeight=\"5\" orient=\"auto\"><path d=\"M0 0L8 4L0 8Z\" "
      "fill=\"#1d4ed8\"/></marker></defs>\n",
      std::max(width, 2 * kMargin), height);
  for (const StateEdge& edge : edges) svg += Arc(edge, top);
  for (size_t i = 0; i < states.size(); ++i) svg += Box(states[i], i, top);
  return svg + "</svg>\n";
}

}  // namespace tact::provers
