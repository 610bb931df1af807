#include "algebra/knot/exact_drawing.h"

#include <cmath>
#include <numbers>

#include "algebra/error.h"
#include "algebra/exact/sparse_solve.h"

namespace tact::knot {
namespace {

using algebra::Rational;
using Triangles = std::vector<std::array<int, 3>>;

size_t At(int i) { return static_cast<size_t>(i); }

PlanePoint operator+(const PlanePoint& a, const PlanePoint& b) { return {a.x + b.x, a.y + b.y}; }
PlanePoint operator-(const PlanePoint& a, const PlanePoint& b) { return {a.x - b.x, a.y - b.y}; }
PlanePoint operator*(const Rational& s, const PlanePoint& a) { return {s * a.x, s * a.y}; }
Rational Dot(const PlanePoint& a, const PlanePoint& b) { return a.x * b.x + a.y * b.y; }
Rational Cross(const PlanePoint& a, const PlanePoint& b) { return a.x * b.y - a.y * b.x; }

bool AllPositive(const Triangles& triangles, const std::vector<PlanePoint>& points) {
  for (const auto& [a, b, c] : triangles) {
    if (Cross(points[At(b)] - points[At(a)], points[At(c)] - points[At(a)]).sign() <= 0) return false;
  }
  return true;
}

struct GridPoint {
  long x, y;
};

// Integers near a circle, clockwise; so far out that rounding leaves each corner convex.
std::vector<GridPoint> ConvexPolygon(size_t corners) {
  const double radius = 4 * static_cast<double>(corners * corners);
  std::vector<GridPoint> polygon;
  for (size_t k = 0; k < corners; ++k) {
    const double angle = -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    polygon.push_back({std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))});
  }
  return polygon;
}

// On a grid of 1 / 2^bits.
std::vector<PlanePoint> Rounded(const std::vector<PlanePoint>& points, int bits) {
  const auto round = [&](const Rational& value) {
    return Rational(algebra::Integer(std::llround(std::ldexp(ToDouble(value), bits))),
                    algebra::Integer(1LL << bits));
  };
  std::vector<PlanePoint> rounded;
  for (const PlanePoint& point : points) rounded.push_back({round(point.x), round(point.y)});
  return rounded;
}

// The vertices round each one, counterclockwise, as successors: next[v] lists (a, b) for each triangle v a b.
class Links {
 public:
  explicit Links(const DiagramTriangulation& t) : next_(At(t.vertices)) {
    for (const auto& [a, b, c] : t.triangles) {
      next_[At(a)].push_back({b, c});
      next_[At(b)].push_back({c, a});
      next_[At(c)].push_back({a, b});
    }
  }
  int After(int v, int neighbour) const {
    for (const auto& [from, to] : next_[At(v)]) {
      if (from == neighbour) return to;
    }
    throw InvariantError("a vertex is not inside its triangles");
  }

 private:
  std::vector<std::vector<std::pair<int, int>>> next_;
};

// How the lower strand goes from vertex `in` to vertex `out` round v: counterclockwise, through the edge of the upper strand between.
class LowerStrand {
 public:
  LowerStrand(const std::vector<PlanePoint>& points, const Links& links, int v)
      : points_(points), links_(links), v_(v) {}

  std::vector<PlanePoint> Round(int in, int out, std::array<int, 2> upper) const {
    std::vector<int> before, after;
    int at = links_.After(v_, in);
    for (; at != upper[0] && at != upper[1]; at = links_.After(v_, at)) before.push_back(at);
    const int crossed = at;
    for (at = links_.After(v_, at); at != out; at = links_.After(v_, at)) after.push_back(at);

    // Near the edge v-crossed the strand keeps so far out along it that it meets it beyond v.
    const PlanePoint along = From(crossed), a = From(before.back()), b = From(after.front());
    const Rational left = Cross(along, b), right = -Cross(along, a);
    const Rational ahead = Dot(along, left * a + right * b), length = (left + right) * Dot(along, along);
    Rational out_along = 1;
    while ((ahead + out_along * length).sign() <= 0) out_along = 2 * out_along;
    const Rational scale = Rational(1) / (2 * (1 + out_along));

    std::vector<PlanePoint> path;
    for (const int vertex : before) path.push_back(Near(scale * From(vertex)));
    path.push_back(Near(scale * (a + out_along * along)));
    path.push_back(Near(scale * (b + out_along * along)));
    for (const int vertex : after) path.push_back(Near(scale * From(vertex)));
    return path;
  }

 private:
  PlanePoint From(int vertex) const { return points_[At(vertex)] - points_[At(v_)]; }
  PlanePoint Near(const PlanePoint& offset) const { return points_[At(v_)] + offset; }

  const std::vector<PlanePoint>& points_;
  const Links& links_;
  int v_;
};

}  // namespace

std::vector<PlanePoint> EmbedTriangulation(const DiagramTriangulation& t) {
  const std::vector<GridPoint> polygon = ConvexPolygon(t.boundary.size());
  const int inner = t.vertices - static_cast<int>(t.boundary.size());
  std::vector<algebra::SparseEntry> laplacian;
  std::vector<long> degree(At(inner), 0), x(At(inner), 0), y(At(inner), 0);
  for (const auto& triangle : t.triangles) {
    for (size_t k = 0; k < 3; ++k) {  // each edge at an inner vertex is seen once in this direction
      const int from = triangle[k], to = triangle[(k + 1) % 3];
      if (from >= inner) continue;
      ++degree[At(from)];
      if (to < inner) {
        laplacian.push_back({from, to, -1});
      } else {
        x[At(from)] += polygon[At(to - inner)].x;
        y[At(from)] += polygon[At(to - inner)].y;
      }
    }
  }
  for (int v = 0; v < inner; ++v) laplacian.push_back({v, v, degree[At(v)]});
  const auto solution = algebra::SolveSparse(laplacian, {x, y});
  std::vector<PlanePoint> points;
  for (int v = 0; v < inner; ++v) points.push_back({solution[0][At(v)], solution[1][At(v)]});
  for (const GridPoint& corner : polygon) points.push_back({corner.x, corner.y});
  for (const int bits : {0, 8, 16, 24, 32}) {
    std::vector<PlanePoint> rounded = Rounded(points, bits);
    if (AllPositive(t.triangles, rounded)) return rounded;
  }
  if (!AllPositive(t.triangles, points)) throw InvariantError("a diagram's triangulation was not embedded");
  return points;
}

Curve DrawExactly(const PData& p, int outer) {
  const DiagramTriangulation t = TriangulateDiagram(p, outer);
  const std::vector<PlanePoint> points = EmbedTriangulation(t);
  const Links links(t);
  Curve curve;
  size_t column = 0;
  for (size_t k = 0; k < t.rope.size(); ++k) {
    const bool meets = column < t.place.size() && At(t.place[column]) == k;
    column += meets ? 1 : 0;
    const int v = t.rope[k];
    if (!meets || p.over(static_cast<int>(column))) {
      curve.push_back({points[At(v)].x, points[At(v)].y, 0});
      continue;
    }
    const size_t mate = At(t.place[At(p.sigma(static_cast<int>(column))) - 1]);
    const LowerStrand strand(points, links, v);
    for (const PlanePoint& point :
         strand.Round(t.rope[k - 1], t.rope[k + 1], {t.rope[mate - 1], t.rope[mate + 1]}))
      curve.push_back({point.x, point.y, -1});
  }
  return curve;
}

}  // namespace tact::knot
