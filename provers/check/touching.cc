#include "provers/check/touching.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace tact::check {
namespace {

using Sign = std::optional<int>;

// The hull of some corners of a piece that lie in a plane, in the piece's own frame.
struct Polygon {
  int dimension = 0;
  std::vector<std::size_t> corners;
  Row normal;  // of dimension 2
  std::vector<std::pair<std::size_t, std::size_t>>
      edges;  // of dimension 2 counter-clockwise, of 1 the segment
};

Polygon MakePolygon(const Piece& piece, const std::vector<std::size_t>& corners) {
  Polygon polygon{0, corners, Row(3), {}};
  const Row& first = piece[corners[0]];
  Row along(3);
  for (const std::size_t i : corners) {
    const Row d = Difference(piece[i], first);
    if (polygon.dimension == 0 && d != Row(3)) {
      along = d;
      polygon.dimension = 1;
    } else if (polygon.dimension == 1 && Cross(along, d) != Row(3)) {
      polygon.normal = Cross(along, d);
      polygon.dimension = 2;
    }
  }
  // An edge has no corner to its right, and those on its line between its ends.
  for (const std::size_t k : corners) {
    for (const std::size_t l : corners) {
      const Row d = Difference(piece[l], piece[k]);
      const bool is_edge = d != Row(3) && std::all_of(corners.begin(), corners.end(), [&](std::size_t x) {
                             const Row to = Difference(piece[x], piece[k]),
                                       from = Difference(piece[x], piece[l]);
                             const mpz_class side = Dot(polygon.normal, Cross(d, to));
                             return side > 0 || (side == 0 && Dot(d, to) >= 0 && Dot(d, from) <= 0);
                           });
      if (is_edge && (polygon.dimension == 2 || polygon.edges.empty())) polygon.edges.emplace_back(k, l);
    }
  }
  return polygon;
}

// A polygon and the other one's corners in one frame.
struct View {
  Polygon polygon;
  PolynomialVector normal;
  std::vector<PolynomialVector> along;  // of each edge
  std::vector<PolynomialPoint> tail, head;
  std::vector<PolynomialPoint> others;

  Polynomial Side(std::size_t edge, std::size_t other) const {
    return Dot(normal, Cross(along[edge], Difference(others[other], tail[edge])));
  }

  // Whether the other's corner is in the polygon throughout; nothing if that is not decided.
  std::optional<bool> Holds(std::size_t other) const {
    std::vector<Sign> inside;  // each is to be 0 or 1
    if (polygon.dimension == 0) {
      for (const Polynomial& d : Difference(others[other], tail[0])) {
        const Sign sign = SignOn(d);
        inside.push_back(sign && *sign != 0 ? Sign(-1) : sign);
      }
    }
    for (std::size_t e = 0; e < polygon.edges.size(); ++e) {
      const Sign side = SignOn(Side(e, other));
      inside.push_back(polygon.dimension == 1 && side && *side != 0 ? Sign(-1) : side);
      if (polygon.dimension == 2) continue;
      inside.push_back(SignOn(Dot(along[e], Difference(others[other], tail[e]))));
      inside.push_back(SignOn(Dot(along[e], Difference(head[e], others[other]))));
    }
    bool all = true;
    for (const Sign& sign : inside) {
      if (sign && *sign < 0) return false;
      all = all && sign;
    }
    return all ? std::optional(true) : std::nullopt;
  }

  // Whether the edge's line has the two on its two sides throughout, strictly; nothing if that is not decided.
  std::optional<bool> Parts(std::size_t edge, std::size_t one, std::size_t two) const {
    const Sign a = SignOn(Side(edge, one)), b = SignOn(Side(edge, two));
    if (!a || !b) return std::nullopt;
    return *a * *b < 0;
  }
};

View FixedView(const PlanePair& pair, const Path& path, const Stage& stage) {
  View view{MakePolygon(pair.fixed, pair.fixed_corners), pair.normal, {}, {}, {}, {}};
  const Polygon& polygon = view.polygon;
  if (polygon.dimension == 2) view.normal = Constant(polygon.normal);
  for (const auto& [k, l] : polygon.edges) {
    view.along.push_back(Constant(Difference(pair.fixed[l], pair.fixed[k])));
    view.tail.push_back(Standing(pair.fixed[k]));
    view.head.push_back(Standing(pair.fixed[l]));
  }
  if (polygon.edges.empty()) view.tail.push_back(Standing(pair.fixed[polygon.corners[0]]));
  for (const Row& corner : pair.moving) view.others.push_back(path.Carry(corner, stage));
  return view;
}

// In the moving frame if the polygon has a normal of its own, else in the fixed one.
View MovingView(const PlanePair& pair, const Path& path, const Stage& stage) {
  View view{MakePolygon(pair.moving, pair.moving_corners), pair.normal, {}, {}, {}, {}};
  const Polygon& polygon = view.polygon;
  const bool own = polygon.dimension == 2;
  const auto place = [&](const Row& corner) { return own ? Standing(corner) : path.Carry(corner, stage); };
  if (own) view.normal = Constant(polygon.normal);
  for (const auto& [k, l] : polygon.edges) {
    const Row d = Difference(pair.moving[l], pair.moving[k]);
    view.along.push_back(own ? Constant(d) : path.Turn(d, stage));
    view.tail.push_back(place(pair.moving[k]));
    view.head.push_back(place(pair.moving[l]));
  }
  if (polygon.edges.empty()) view.tail.push_back(place(pair.moving[polygon.corners[0]]));
  for (const Row& corner : pair.fixed)
    view.others.push_back(own ? path.CarryBack(corner, stage) : Standing(corner));
  return view;
}

// Between a and b in the proportion of their heights over the line that parts them; w is positive at t = 0.
PolynomialPoint Crossing(const PolynomialPoint& a, const Polynomial& over_a, const PolynomialPoint& b,
                         const Polynomial& over_b) {
  const bool b_above = SignOn(over_b) == 1;
  const auto combine = [&](const Polynomial& x, const Polynomial& y) {
    return b_above ? over_b * x - over_a * y : over_a * y - over_b * x;
  };
  PolynomialPoint point;
  for (std::size_t i = 0; i < 3; ++i) point.xyz[i] = combine(a.xyz[i], b.xyz[i]);
  point.w = combine(a.w, b.w);
  return point;
}

}  // namespace

TouchingAnswer TouchingCorners(const PlanePair& pair, const Path& path, const Stage& stage) {
  TouchingAnswer answer;
  if (pair.moving_corners.empty() || pair.fixed_corners.empty()) return answer;
  const View of_fixed = FixedView(pair, path, stage), of_moving = MovingView(pair, path, stage);
  const auto add = [&](std::optional<bool> touches, TouchingCorner corner, const std::string& name) {
    if (!touches) answer.undecided = name;
    if (touches == true) answer.corners.push_back(std::move(corner));
  };
  for (const std::size_t m : pair.moving_corners)
    add(of_fixed.Holds(m), {{m}, {}, of_fixed.others[m]}, "moving corner " + std::to_string(m));
  for (const std::size_t f : pair.fixed_corners)
    add(of_moving.Holds(f), {{}, {f}, Standing(pair.fixed[f])}, "fixed corner " + std::to_string(f));
  for (std::size_t e = 0; e < of_moving.polygon.edges.size(); ++e) {
    for (std::size_t g = 0; g < of_fixed.polygon.edges.size(); ++g) {
      const auto [a, b] = std::minmax(of_moving.polygon.edges[e].first, of_moving.polygon.edges[e].second);
      const auto [c, d] = std::minmax(of_fixed.polygon.edges[g].first, of_fixed.polygon.edges[g].second);
      const auto moving_parts = of_moving.Parts(e, c, d), fixed_parts = of_fixed.Parts(g, a, b);
      if (moving_parts == false || fixed_parts == false) continue;
      const bool decided = moving_parts && fixed_parts;
      add(decided ? std::optional(true) : std::nullopt,
          {{a, b},
           {c, d},
           Crossing(of_fixed.others[a], of_fixed.Side(g, a), of_fixed.others[b], of_fixed.Side(g, b))},
          "moving edge " + std::to_string(a) + " to " + std::to_string(b) + " on fixed edge " +
              std::to_string(c) + " to " + std::to_string(d));
    }
  }
  std::sort(answer.corners.begin(), answer.corners.end());
  return answer;
}

}  // namespace tact::check
