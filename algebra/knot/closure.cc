#include "algebra/knot/closure.h"

#include <algorithm>
#include <cstdlib>

#include "algebra/error.h"

namespace tact::knot {
namespace {

constexpr Dart kSelectiveEnd{1, false};

Dart OtherEnd(const PData& p) { return {p.segments(), true}; }

}  // namespace

bool EndsOnOneFace(const PData& p) {
  const Dart first = OtherEnd(p);
  Dart d = first;
  do {
    if (d == kSelectiveEnd) return true;
    d = NextDart(p, d);
  } while (d != first);
  return false;
}

std::vector<Dart> ClosingPath(const PData& p) {
  const Faces faces(p);
  const int start = faces.left_of(OtherEnd(p)), goal = faces.left_of(kSelectiveEnd);
  std::vector<Dart> entered(static_cast<size_t>(faces.count()));  // the dart that was passed to enter a face
  std::vector<bool> seen(entered.size(), false);
  std::vector<int> queue = {start};
  seen[static_cast<size_t>(start)] = true;
  for (size_t next = 0; next < queue.size() && !seen[static_cast<size_t>(goal)]; ++next) {
    for (const Dart d : faces.walk(queue[next])) {
      const int face = faces.left_of(Opposite(d));
      if (seen[static_cast<size_t>(face)]) continue;
      seen[static_cast<size_t>(face)] = true;
      entered[static_cast<size_t>(face)] = d;
      queue.push_back(face);
    }
  }
  std::vector<Dart> path;
  for (int face = goal; face != start; face = faces.left_of(path.back()))
    path.push_back(entered[static_cast<size_t>(face)]);
  std::reverse(path.begin(), path.end());
  return path;
}

PData CloseBy(const PData& p, Pass pass) {
  // A shortest path crosses no segment twice.
  const std::vector<Dart> path = ClosingPath(p);
  const int n = p.columns(), added = static_cast<int>(path.size());
  std::vector<int> crossed(static_cast<size_t>(p.segments()) + 1, 0);  // place on the path, from 1
  for (int t = 1; t <= added; ++t) crossed[static_cast<size_t>(path[static_cast<size_t>(t) - 1].segment)] = t;
  std::vector<int> before(static_cast<size_t>(p.segments()) + 1, 0);  // crossed segments up to this one
  for (size_t s = 1; s < before.size(); ++s) before[s] = before[s - 1] + (crossed[s] != 0 ? 1 : 0);
  const auto renumber = [&](int column) { return column + before[static_cast<size_t>(column)]; };
  const bool over = pass == Pass::kOver;
  const auto attribute = [&](int t) {
    // The segment that is passed from its left to its right runs from the arc's right to its left.
    return AttributeOf(over, path[static_cast<size_t>(t) - 1].forward ? 1 : -1);
  };
  PDataBuilder closed(n + 2 * added);
  for (int segment = 1; segment <= n + 1; ++segment) {
    const int t = crossed[static_cast<size_t>(segment)];
    if (t != 0) closed.Add(n + added + t, MateAttribute(attribute(t)));
    if (segment <= n) closed.Add(renumber(p.sigma(segment)), p.attr(segment));
  }
  for (int t = 1; t <= added; ++t) {
    const int segment = path[static_cast<size_t>(t) - 1].segment;
    closed.Add(segment + before[static_cast<size_t>(segment)] - 1, attribute(t));
  }
  return closed.Take();
}

std::string ClosedCode::OrientedGauss() const {
  const GaussCode code = Gauss();
  std::string text;
  for (int i = 1; i <= cut.columns(); ++i) {
    if (!text.empty()) text += ' ';
    text += cut.over(i) ? '+' : '-';
    text += cut.turn(i) > 0 ? '<' : '>';
    text += std::to_string(std::abs(code.passes[static_cast<size_t>(i) - 1]));
  }
  return text;
}

ClosedCode Close(const PData& p, Pass pass) { return {CloseBy(p, pass)}; }

ClosedCode JoinEnds(const PData& p) {
  if (!EndsOnOneFace(p)) throw PreconditionError("JoinEnds: expected both ends on one face, got two faces");
  return {p};
}

}  // namespace tact::knot
