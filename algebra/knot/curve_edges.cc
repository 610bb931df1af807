#include "algebra/knot/curve_edges.h"

#include "algebra/error.h"

namespace tact::knot {
namespace {

using algebra::Integer;
using algebra::Rational;
using algebra::Vector3;

SeenPoint operator-(const SeenPoint& a, const SeenPoint& b) {
  return {a.right - b.right, a.up - b.up, a.height - b.height};
}
Integer Cross(const SeenPoint& a, const SeenPoint& b) { return a.right * b.up - a.up * b.right; }
Integer Dot(const SeenPoint& a, const SeenPoint& b) { return a.right * b.right + a.up * b.up; }

Integer CommonDenominator(const std::vector<Vector3>& points) {
  Integer common = 1;
  for (const Vector3& point : points) {
    for (int i = 0; i < 3; ++i) {
      const Integer& denominator = point[i].denominator();
      common *= DivideExactly(denominator, Gcd(common, denominator));
    }
  }
  return common;
}

// Height of the first edge above the second at a point of both lines' shadows, times a positive number; the point is
// first.from + (a / c) first.along and second.from + (b / c) second.along.
int GapSign(const SeenEdge& first, const Integer& a, const SeenEdge& second, const Integer& b,
            const Integer& c) {
  const Integer gap =
      c * (first.from.height - second.from.height) + a * first.along.height - b * second.along.height;
  return gap.sign() * c.sign();
}

// The shadows are on one line: the part that both cover, in units of first.along over its squared length.
EdgePair CompareOnOneLine(const SeenEdge& first, const SeenEdge& second) {
  const Integer length = Dot(first.along, first.along), from = Dot(second.from - first.from, first.along),
                to = Dot(second.to - first.from, first.along);
  const Integer low = std::max(Integer(0), std::min(from, to)), high = std::min(length, std::max(from, to));
  if (low > high) return {};
  // A place u on first is (u - from) / (to - from) along second: with both over length * (to - from).
  const auto gap = [&](const Integer& u) {
    return GapSign(first, u * (to - from), second, (u - from) * length, length * (to - from));
  };
  EdgePair pair;
  const int at_low = gap(low), at_high = gap(high);
  if (at_low * at_high <= 0) {
    pair.meeting = EdgeMeeting::kInSpace;
  } else if (low < high) {
    pair.meeting = EdgeMeeting::kOverlap;
  } else {
    pair.meeting = EdgeMeeting::kPointOfSecond;
    pair.point = from == low ? 0 : 1;
  }
  return pair;
}

}  // namespace

std::vector<SeenEdge> SeenEdges(const std::vector<Vector3>& points, const Vector3& view) {
  if (view.IsZero()) throw PreconditionError("SeenEdges: expected a view of some length, got zero");
  const Vector3 direction = Primitive(view);
  int z = 2;
  while (direction[z].sign() == 0) --z;
  // Coordinates change places in a cycle until the view's last one is not zero: handedness stays. Then
  // (|z| x - +-x z, ...) vanishes along the view, and the last coordinate grows along it or its negative does.
  const int x = (z + 1) % 3, y = (z + 2) % 3;
  const Integer view_x = direction[x].numerator(), view_y = direction[y].numerator(),
                view_z = direction[z].numerator();
  const Rational scale(CommonDenominator(points));
  std::vector<SeenPoint> seen;
  seen.reserve(points.size());
  for (const Vector3& point : points) {
    const Integer p_x = (scale * point[x]).numerator(), p_y = (scale * point[y]).numerator(),
                  p_z = (scale * point[z]).numerator();
    SeenPoint s{view_z * p_x - view_x * p_z, view_z * p_y - view_y * p_z, p_z};
    if (view_z.sign() < 0) s = {s.up, s.right, -s.height};
    seen.push_back(std::move(s));
  }
  std::vector<SeenEdge> edges;
  edges.reserve(seen.size());
  for (size_t i = 1; i < seen.size(); ++i) edges.push_back({seen[i - 1], seen[i], seen[i] - seen[i - 1]});
  return edges;
}

EdgePair CompareEdges(const SeenEdge& first, const SeenEdge& second) {
  const SeenPoint between = second.from - first.from;
  const Integer cross = Cross(first.along, second.along);
  // Sides of the ends: of second's at first's line, of first's at second's.
  const Integer second_from = Cross(first.along, between), first_from = Cross(between, second.along);
  const Integer second_to = second_from + cross, first_to = first_from - cross;
  if (cross.sign() == 0) return second_from.sign() == 0 ? CompareOnOneLine(first, second) : EdgePair{};
  if (second_from.sign() * second_to.sign() > 0 || first_from.sign() * first_to.sign() > 0) return {};
  EdgePair pair;
  const int gap = GapSign(first, first_from, second, -second_from, cross);
  if (gap == 0) {
    pair.meeting = EdgeMeeting::kInSpace;
  } else if (second_from.sign() == 0 || second_to.sign() == 0) {
    pair.meeting = EdgeMeeting::kPointOfSecond;
    pair.point = second_from.sign() == 0 ? 0 : 1;
  } else if (first_from.sign() == 0 || first_to.sign() == 0) {
    pair.meeting = EdgeMeeting::kPointOfFirst;
    pair.point = first_from.sign() == 0 ? 0 : 1;
  } else {
    pair.meeting = EdgeMeeting::kCrossing;
    pair.at_first = Rational(first_from, cross);
    pair.at_second = Rational(-second_from, cross);
    pair.first_over = gap > 0;
    pair.turn = cross.sign();
  }
  return pair;
}

EdgePair CompareNeighbours(const SeenEdge& first, const SeenEdge& second) {
  EdgePair pair;
  if (Cross(first.along, second.along).sign() != 0 || Dot(first.along, second.along).sign() > 0) return pair;
  const bool in_space =
      (first.along.right * second.along.height - first.along.height * second.along.right).sign() == 0 &&
      (first.along.up * second.along.height - first.along.height * second.along.up).sign() == 0;
  pair.meeting = in_space ? EdgeMeeting::kInSpace : EdgeMeeting::kOverlap;
  return pair;
}

}  // namespace tact::knot
