#include "algebra/contact/path_separation.h"

#include <algorithm>
#include <optional>
#include <set>

#include "algebra/contact/path_polynomial.h"
#include "algebra/error.h"

namespace tact::algebra {
namespace {

constexpr int kMostHalvings = 12;

// The polynomial in t with s = from + t (to - from).
Quadratic Restricted(const Quadratic& p, const Rational& from, const Rational& to) {
  const Rational step = to - from;
  return {p.At(from), step * (p.c1 + Rational(2) * p.c2 * from), step * step * p.c2};
}

struct PlaneTest {
  bool separates = true;  // no corner leaves its side: each is there, or in the plane, all over 0 <= t < 1
  size_t in_plane = 0;    // all over
  bool is_plane = false;  // at the end too: some corner is off it
};

PlaneTest TestPlane(const std::vector<Quadratic>& heights, const Rational& from, const Rational& to) {
  PlaneTest test;
  for (const Quadratic& height : heights) {
    if (height.IsZero()) {
      ++test.in_plane;
      continue;
    }
    const Quadratic here = Restricted(height, from, to);
    if (here.c0.sign() <= 0 || !RootsInside(here).empty()) {
      test.separates = false;
      return test;
    }
    test.is_plane = test.is_plane || height.At(to).sign() > 0;
  }
  return test;
}

using SoupEdges = std::set<std::array<size_t, 2>>;
SoupEdges EdgesOf(const PolygonSoup& hull) {
  SoupEdges edges;
  for (const auto& polygon : hull.polygons) {
    for (size_t i = 0; i < polygon.size(); ++i) {
      const size_t a = polygon[i], b = polygon[(i + 1) % polygon.size()];
      edges.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return edges;
}

// A plane with the polynomials of all corners' heights over it, counted towards the side where they should be.
struct Candidate {
  PathPlane plane;
  std::vector<Quadratic> moving, fixed;
};

class Separator {
 public:
  Separator(const PolygonSoup& moving, const PolygonSoup& fixed, const MotionPath& path)
      : moving_(moving), fixed_(fixed), path_(path), touching_(TouchHalfway()) {
    AddFacets(fixed, moving, path, PathPlane::Kind::kFixed);
    AddFacets(moving, fixed, Backwards(path), PathPlane::Kind::kCarried);
    facets_ = candidates_.size();
  }

  void Separate(const Rational& from, const Rational& to, int halvings, std::vector<PathPlane>& planes) {
    if (const auto best = Best(from, to)) {
      planes.push_back(candidates_[*best].plane);
      planes.back().until = to;
      return;
    }
    if (halvings == 0)
      throw BudgetError("no separating planes found between s = " + from.ToString() + " and " +
                        to.ToString() + " after " + std::to_string(kMostHalvings) + " halvings");
    const Rational middle = Rational(1, 2) * (from + to);
    Separate(from, middle, halvings - 1, planes);
    Separate(middle, to, halvings - 1, planes);
  }

 private:
  // One that keeps the pieces strictly apart, or else the one with the fewest corners in it; edges only if no
  // facet will do.
  std::optional<size_t> Best(const Rational& from, const Rational& to) {
    std::optional<size_t> best;
    size_t fewest = 0;
    for (size_t i = 0;; ++i) {
      if (i == facets_) {
        if (best && touching_) break;
        AddEdges();
      }
      if (i == candidates_.size()) break;
      const PlaneTest moving = TestPlane(candidates_[i].moving, from, to);
      if (!moving.separates) continue;
      const PlaneTest fixed = TestPlane(candidates_[i].fixed, from, to);
      if (!fixed.separates || !(moving.is_plane || fixed.is_plane)) continue;
      if (moving.in_plane == 0 || fixed.in_plane == 0) return i;
      if (!best || moving.in_plane + fixed.in_plane < fewest) {
        best = i;
        fewest = moving.in_plane + fixed.in_plane;
      }
    }
    return best;
  }

  bool TouchHalfway() const {
    const Pose halfway = path_.At(Rational(1, 2));
    const auto found = FindContacts(Transform(BuildPolyhedron(moving_), halfway), BuildPolyhedron(fixed_), 0);
    return !found.relation.contacts.empty();
  }

  // Outward facets of one piece and the other's corners carried along the path.
  void AddFacets(const PolygonSoup& piece, const PolygonSoup& other, const MotionPath& path,
                 PathPlane::Kind kind) {
    for (const auto& polygon : piece.polygons) {
      const Vector3& base = piece.points[polygon[0]];
      const Vector3 normal =
          Primitive(Cross(piece.points[polygon[1]] - base, piece.points[polygon[2]] - base));
      const Rational offset = Dot(normal, base);
      Candidate candidate;
      std::vector<Quadratic> own, others;
      for (const Vector3& p : piece.points) own.push_back({offset - Dot(normal, p), 0, 0});
      for (const Vector3& p : other.points) others.push_back(HeightAlong(path, p, normal, offset));
      const bool carried = kind == PathPlane::Kind::kCarried;
      candidate.plane = {kind, 0, polygon[0], carried ? -normal : normal, {}, {}};
      candidate.moving = carried ? own : others;
      candidate.fixed = carried ? others : own;
      candidates_.push_back(std::move(candidate));
    }
  }

  void AddEdges() {
    if (edges_added_) return;
    edges_added_ = true;
    const std::vector<Vector3>&m = moving_.points, &f = fixed_.points;
    for (const auto& [a, b] : EdgesOf(moving_)) {
      for (const auto& [c, d] : EdgesOf(fixed_)) {
        for (const bool turned : {false, true}) {
          const std::array<size_t, 2> edge = turned ? std::array{b, a} : std::array{a, b};
          const Vector3 along = m[edge[1]] - m[edge[0]], other = f[d] - f[c];
          Candidate candidate;
          candidate.plane = {PathPlane::Kind::kEdges, 0, c, {}, edge, {c, d}};
          for (const Vector3& p : m) candidate.moving.push_back(MeetingAlong(path_, p, along, f[c], other));
          for (const Vector3& p : f) {
            candidate.fixed.push_back(MeetingAlong(path_, m[0], along, p, other) -
                                      MeetingAlong(path_, m[0], along, f[c], other));
          }
          candidates_.push_back(std::move(candidate));
        }
      }
    }
  }

  const PolygonSoup& moving_;
  const PolygonSoup& fixed_;
  MotionPath path_;
  bool touching_;  // halfway, and hence all along a path that FollowPath accepts
  std::vector<Candidate> candidates_;
  size_t facets_ = 0;
  bool edges_added_ = false;
};

}  // namespace

std::vector<PathPlane> SeparateAlong(const PolygonSoup& moving_hull, const PolygonSoup& fixed_hull,
                                     const MotionPath& path) {
  Separator separator(moving_hull, fixed_hull, path);
  std::vector<PathPlane> planes;
  separator.Separate(0, 1, kMostHalvings, planes);
  return planes;
}

}  // namespace tact::algebra
