#include <algorithm>

#include "algebra/contact/contact_finder.h"
#include "algebra/solid/bounding_box.h"
#include "algebra/solid/distance.h"

namespace tact::algebra {
namespace {

BoundingBox BoxOf(const Polyhedron& solid) {
  BoundingBox box;
  for (const Vertex& v : solid.vertices) box.Add(v.point);
  return box;
}

// Looks for points of one solid's skeleton deep inside the other.
class Search {
 public:
  explicit Search(const Rational& tolerance) : squared_tolerance_(tolerance * tolerance) {}

  void Skeleton(const Polyhedron& skeleton, const Polyhedron& solid) {
    const BoundingBox whole = BoxOf(solid);
    const SurfaceDistance surface(solid);
    std::vector<BoundingBox> face_boxes;
    for (const Face& face : solid.faces) {
      face_boxes.emplace_back();
      for (const size_t v : face.loops[0]) face_boxes.back().Add(solid.vertices[v].point);
    }
    for (const Vertex& v : skeleton.vertices) {
      BoundingBox box;
      box.Add(v.point);
      if (box.Near(whole, 0)) Look(solid, surface, v.point);
    }
    for (const Edge& edge : skeleton.edges) {
      const Vector3 &a = skeleton.vertices[edge.tail].point, &b = skeleton.vertices[edge.head].point;
      BoundingBox box;
      box.Add(a);
      box.Add(b);
      if (box.Near(whole, 0)) LookAlong(solid, surface, face_boxes, box, a, b);
    }
  }

  const std::optional<Penetration>& deepest() const { return deepest_; }

 private:
  void Look(const Polyhedron& solid, const SurfaceDistance& surface, const Vector3& p) {
    if (Locate(solid, p) != Side::kInside) return;
    const Rational depth = surface.Squared(p);
    if (depth <= squared_tolerance_ || (deepest_ && depth <= deepest_->squared_depth)) return;
    deepest_ = Penetration{p, depth};
  }

  // Between two points where the edge meets the surface it is inside, outside, or on it all along.
  void LookAlong(const Polyhedron& solid, const SurfaceDistance& surface,
                 const std::vector<BoundingBox>& face_boxes, const BoundingBox& box, const Vector3& a,
                 const Vector3& b) {
    std::vector<Rational> cuts = {0, 1};
    for (size_t f = 0; f < solid.faces.size(); ++f) {
      if (!box.Near(face_boxes[f], 0)) continue;
      const Face& face = solid.faces[f];
      const Rational at_a = Dot(face.normal, a) - face.offset, at_b = Dot(face.normal, b) - face.offset;
      if (at_a.sign() * at_b.sign() >= 0) continue;
      const Rational t = at_a / (at_a - at_b);
      if (FaceContains(solid, face, a + t * (b - a))) cuts.push_back(t);
    }
    std::sort(cuts.begin(), cuts.end());
    for (size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] != cuts[i + 1])
        Look(solid, surface, a + (Rational(1, 2) * (cuts[i] + cuts[i + 1])) * (b - a));
    }
  }

  Rational squared_tolerance_;
  std::optional<Penetration> deepest_;
};

}  // namespace

std::optional<Penetration> FindPenetration(const Polyhedron& moving, const Polyhedron& fixed,
                                           const Rational& tolerance) {
  Search search(tolerance);
  search.Skeleton(moving, fixed);
  search.Skeleton(fixed, moving);
  return search.deepest();
}

}  // namespace tact::algebra
