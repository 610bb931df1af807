// `knot-drawing`: a rope in space, point by point, whose projection along z is what the P-data says.
#include <algorithm>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/knot_code.h"

namespace tact::check {
namespace {

// A point is (x, y, z) / w with w > 0.
struct Point {
  mpz_class x, y, z, w;
};
struct Edge {
  const Point *from, *to;
};

// Twice the area of a, b, c times their denominators: positive if they turn to the left.
mpz_class Turn(const Point& a, const Point& b, const Point& c) {
  return a.x * (b.y * c.w - c.y * b.w) - a.y * (b.x * c.w - c.x * b.w) + a.w * (b.x * c.y - c.x * b.y);
}

// A place on an edge: at / of of the way, 0 < at < of.
struct Passage {
  std::size_t edge;
  mpz_class at, of;
  std::size_t intersection;
  bool over, plus;
};

// Whether one edge is over the other where both are at the given shares of their ways.
int Higher(const Edge& a, const mpz_class& a_at, const mpz_class& a_of, const Edge& b, const mpz_class& b_at,
           const mpz_class& b_of) {
  const auto height = [](const Edge& e, const mpz_class& at, const mpz_class& of, mpz_class& below) {
    below = of * e.from->w * e.to->w;
    return mpz_class(e.from->z * e.to->w * (of - at) + e.to->z * e.from->w * at);
  };
  mpz_class under_a, under_b;
  const mpz_class over_a = height(a, a_at, a_of, under_a), over_b = height(b, b_at, b_of, under_b);
  return cmp(over_a * under_b, over_b * under_a);
}

// Edges without common points that are seen apart, or cross each other inside.
bool CrossInside(const Edge& a, const Edge& b, const Value& where) {
  const int f = sgn(Turn(*a.from, *a.to, *b.from)), t = sgn(Turn(*a.from, *a.to, *b.to));
  const int g = sgn(Turn(*b.from, *b.to, *a.from)), u = sgn(Turn(*b.from, *b.to, *a.to));
  if (f * t < 0 && g * u < 0) return true;
  if (f * t > 0 || g * u > 0) return false;
  // A point is in line with the other edge: it must not be on it.
  if (f != 0 || t != 0) {
    if ((f == 0 || t == 0) && g * u <= 0) throw Refused(&where, "a point is seen on an edge");
    if ((g == 0 || u == 0) && f * t <= 0) throw Refused(&where, "a point is seen on an edge");
    return false;
  }
  // All in one line: apart if one ends before the other begins, in x or in y.
  const auto apart = [&](mpz_class Point::*coordinate) {
    const auto less = [&](const Point* p, const Point* q) {
      return p->*coordinate * q->w < q->*coordinate * p->w;
    };
    const auto [a0, a1] = std::minmax(a.from, a.to, less);
    const auto [b0, b1] = std::minmax(b.from, b.to, less);
    return less(a1, b0) || less(b1, a0);
  };
  if (apart(&Point::x) || apart(&Point::y)) return false;
  throw Refused(&where, "edges are seen on one line");
}

bool SeenAtOnePlace(const Point& a, const Point& b) {
  return a.x * b.w == b.x * a.w && a.y * b.w == b.y * a.w;
}

// The two passages of each intersection, in the order in which the edges are tried.
std::vector<Passage> Passages(const std::vector<Point>& points, const Array& where) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (SeenAtOnePlace(points[k], points[k + 1]))
      throw Refused(&where[k + 1], "seen where the point before it is");
    edges.push_back({&points[k], &points[k + 1]});
  }
  std::vector<Passage> passages;
  for (std::size_t j = 1; j < edges.size(); ++j) {
    // The next edge may go on in any direction but back.
    if (Turn(*edges[j - 1].from, *edges[j - 1].to, *edges[j].to) == 0) {
      const Point &a = *edges[j - 1].from, &b = *edges[j].from, &c = *edges[j].to;
      const mpz_class ahead = (b.x * a.w - a.x * b.w) * (c.x * b.w - b.x * c.w) +
                              (b.y * a.w - a.y * b.w) * (c.y * b.w - b.y * c.w);
      if (ahead < 0) throw Refused(&where[j + 1], "the rope is seen to turn back on itself");
    }
    for (std::size_t i = 0; i + 1 < j; ++i) {
      const Edge &a = edges[i], &b = edges[j];
      if (!CrossInside(a, b, where[j])) continue;
      // Areas on both sides of the other edge, at the same denominators, divide each edge.
      const mpz_class a0 = abs(Turn(*b.from, *b.to, *a.from)) * a.to->w,
                      a1 = abs(Turn(*b.from, *b.to, *a.to)) * a.from->w;
      const mpz_class b0 = abs(Turn(*a.from, *a.to, *b.from)) * b.to->w,
                      b1 = abs(Turn(*a.from, *a.to, *b.to)) * b.from->w;
      const int higher = Higher(a, a0, a0 + a1, b, b0, b0 + b1);
      if (higher == 0) throw Refused(&where[j], "the rope meets itself");
      const bool b_from_right = sgn(Turn(*a.from, *a.to, *b.from)) < 0;  // b passes a from right to left
      const bool plus = b_from_right == (higher > 0);
      const std::size_t intersection = passages.size() / 2;
      passages.push_back({i, a0, a0 + a1, intersection, higher > 0, plus});
      passages.push_back({j, b0, b0 + b1, intersection, higher < 0, plus});
    }
  }
  return passages;
}

}  // namespace

void CheckKnotDrawing(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "points"});
  const KnotCode code = ReadKnotCode(At(certificate, "p_data"));
  const Array& where = AsArray(At(certificate, "points"));
  if (where.size() < 2) throw Refused(&At(certificate, "points"), "expected at least two points");
  std::vector<Point> points;
  for (const Value& text : where) {
    const std::vector<mpz_class> p = AsIntegers(text, 4);
    if (p[3] <= 0) throw Refused(&text, "expected a positive denominator");
    points.push_back({p[0], p[1], p[2], p[3]});
  }
  std::vector<Passage> passages = Passages(points, where);
  std::sort(passages.begin(), passages.end(), [](const Passage& a, const Passage& b) {
    return a.edge != b.edge ? a.edge < b.edge : a.at * b.of < b.at * a.of;
  });
  KnotCode drawn;
  drawn.sigma.resize(passages.size());
  std::vector<std::size_t> first(passages.size() / 2, passages.size());
  for (std::size_t k = 0; k < passages.size(); ++k) {
    const Passage& p = passages[k];
    if (k > 0 && passages[k - 1].edge == p.edge && passages[k - 1].at * p.of == p.at * passages[k - 1].of)
      throw Refused(&where[p.edge], "three edges are seen through one point");
    drawn.attr.push_back(1 + (p.over ? 0 : 1) + (p.plus ? 2 : 0));
    std::size_t& other = first[p.intersection];
    if (other == passages.size()) {
      other = k;
    } else {
      drawn.sigma[k] = static_cast<int>(other) + 1;
      drawn.sigma[other] = static_cast<int>(k) + 1;
    }
  }
  if (drawn.columns() != code.columns())
    throw Refused(&At(certificate, "points"),
                  "the drawing has " + std::to_string(drawn.columns() / 2) + " intersections");
  if (drawn != code) throw Refused(&At(certificate, "p_data"), "the drawing is of other P-data");
}

}  // namespace tact::check
