#include "algebra/contact/contact_finder.h"

#include <algorithm>
#include <map>
#include <set>

#include "algebra/contact/separate_planes.h"
#include "algebra/error.h"
#include "algebra/solid/distance.h"
#include "algebra/solid/point_locator.h"

namespace tact::algebra {
namespace {

// A solid with what the search asks of it again and again.
class Body {
 public:
  explicit Body(const Polyhedron& polyhedron) : solid(polyhedron) {
    for (const Vertex& v : solid.vertices) vertex_boxes.push_back(BoxOf(v.point));
    for (const Edge& e : solid.edges) {
      edge_boxes.push_back(vertex_boxes[e.tail]);
      edge_boxes.back().Add(vertex_boxes[e.head]);
    }
    face_boxes = FaceBoxes(solid);
  }

  const Vector3& point(size_t v) const { return solid.vertices[v].point; }
  const Vector3& tail(size_t e) const { return point(solid.edges[e].tail); }
  const Vector3& head(size_t e) const { return point(solid.edges[e].head); }

  // What the solid looks like at the element's point nearest to p: several elements share it where shells
  // touch or a shell is pinched.
  struct Place {
    std::vector<Element> elements;
    std::vector<ConvexPiece> pieces;
  };
  const Place& At(const Element& element, const Vector3& p) {
    const Vector3 nearest = Nearest(element, p);
    const auto [at, fresh] = places_.try_emplace(nearest);
    if (fresh) at->second = {ElementsAt(solid, nearest), LocalPieces(solid, nearest)};
    return at->second;
  }
  // The element if it bounds the piece, or else one of its place that does.
  Element Bounding(const Element& element, const Place& place, const ConvexPiece& piece) const {
    if (Bounds(solid, element, piece)) return element;
    for (const Element& other : place.elements) {
      if (Bounds(solid, other, piece)) return other;
    }
    return element;
  }

  const Polyhedron& solid;
  std::vector<BoundingBox> vertex_boxes, edge_boxes, face_boxes;

 private:
  Vector3 Nearest(const Element& element, const Vector3& p) const {
    if (element.kind == ElementKind::kVertex) return point(element.index);
    if (element.kind == ElementKind::kFace) return ProjectOntoPlane(p, solid.faces[element.index]);
    return NearestOnSegment(p, tail(element.index), head(element.index)).point;
  }

  std::map<Vector3, Place> places_;
};

class Finder {
 public:
  Finder(const Polyhedron& moving, const Polyhedron& fixed, const Rational& tolerance)
      : moving_(moving),
        fixed_(fixed),
        tolerance_(tolerance),
        squared_tolerance_(tolerance * tolerance),
        reach_(ToDouble(tolerance) * (1 + 1e-9)) {}

  FoundContacts Run() {
    for (size_t v = 0; v < moving_.solid.vertices.size(); ++v) {
      for (const Element& near : NearVertex(moving_.point(v), moving_.vertex_boxes[v], fixed_, true)) {
        Add(moving_.point(v), {ElementKind::kVertex, v}, near);
      }
    }
    for (size_t v = 0; v < fixed_.solid.vertices.size(); ++v) {
      for (const Element& near : NearVertex(fixed_.point(v), fixed_.vertex_boxes[v], moving_, false)) {
        Add(fixed_.point(v), near, {ElementKind::kVertex, v});
      }
    }
    CrossEdges();
    if (overlaps_) {
      const Penetration deepest = DeepestMidpoint();
      if (tolerance_.sign() == 0 || deepest.squared_depth > squared_tolerance_) {
        found_ = {};
        found_.penetration = deepest;
        return found_;
      }
    }
    DropImplied();
    found_.primitives =
        GroupIntoPrimitives(moving_.solid, fixed_.solid, found_.relation, found_.elements, tolerance_);
    NameContacts();
    return found_;
  }

 private:
  bool Close(const Vector3& a, const Vector3& b) const { return SquaredDistance(a, b) <= squared_tolerance_; }

  bool NearEdge(const Vector3& p, const Body& body, size_t e) const {
    return Close(p, NearestOnSegment(p, body.tail(e), body.head(e)).point);
  }

  // The elements of the body within the tolerance of p, lowest dimension first: an edge counts only if
  // neither of its ends does, a face only if none of its edges does.
  std::vector<Element> NearVertex(const Vector3& p, const BoundingBox& box, const Body& body,
                                  bool vertices_too) const {
    std::vector<Element> near;
    for (size_t v = 0; v < body.vertex_boxes.size() && vertices_too; ++v) {
      if (box.Near(body.vertex_boxes[v], reach_) && Close(p, body.point(v)))
        near.push_back({ElementKind::kVertex, v});
    }
    for (size_t e = 0; e < body.edge_boxes.size(); ++e) {
      if (!box.Near(body.edge_boxes[e], reach_) || Close(p, body.tail(e)) || Close(p, body.head(e))) continue;
      if (NearEdge(p, body, e)) near.push_back({ElementKind::kEdge, e});
    }
    for (size_t f = 0; f < body.face_boxes.size(); ++f) {
      if (box.Near(body.face_boxes[f], reach_) && NearFaceOnly(p, body, body.solid.faces[f])) {
        near.push_back({ElementKind::kFace, f});
      }
    }
    return near;
  }

  bool NearFaceOnly(const Vector3& p, const Body& body, const Face& face) const {
    const Rational excess = Dot(face.normal, p) - face.offset;
    if (excess * excess > squared_tolerance_ * Dot(face.normal, face.normal)) return false;
    for (const auto& edges : face.loop_edges) {
      for (const size_t e : edges) {
        if (NearEdge(p, body, e)) return false;
      }
    }
    return FaceContains(body.solid, face, ProjectOntoPlane(p, face));
  }

  void CrossEdges() {
    for (size_t e = 0; e < moving_.edge_boxes.size(); ++e) {
      for (size_t g = 0; g < fixed_.edge_boxes.size(); ++g) {
        if (moving_.edge_boxes[e].Near(fixed_.edge_boxes[g], reach_)) CrossEdgePair(e, g);
      }
    }
  }

  void CrossEdgePair(size_t e, size_t g) {
    const Vector3 &a = moving_.tail(e), &b = moving_.head(e), &c = fixed_.tail(g), &d = fixed_.head(g);
    if (Parallel(b - a, d - c)) return;
    const SegmentPair nearest = NearestOnSegments(a, b, c, d);
    const auto inner = [](const SegmentPoint& p) {
      return p.parameter.sign() > 0 && p.parameter < Rational(1);
    };
    if (!inner(nearest.first) || !inner(nearest.second) || !Close(nearest.first.point, nearest.second.point))
      return;
    if (NearEdge(a, fixed_, g) || NearEdge(b, fixed_, g) || NearEdge(c, moving_, e) ||
        NearEdge(d, moving_, e))
      return;
    Add(nearest.first.point, {ElementKind::kEdge, e}, {ElementKind::kEdge, g});
  }

  void Add(const Vector3& point, const Element& moving, const Element& fixed) {
    corners_.push_back(point);
    const Body::Place &of_moving = moving_.At(moving, point), &of_fixed = fixed_.At(fixed, point);
    for (const ConvexPiece& m : of_moving.pieces) {
      for (const ConvexPiece& f : of_fixed.pieces) {
        std::vector<Vector3> planes = SeparatePlanes(m, f, tolerance_);
        if (planes.empty()) {
          overlaps_ = true;
          continue;
        }
        found_.relation.contacts.push_back({point, std::move(planes), ""});
        found_.elements.emplace_back(moving_.Bounding(moving, of_moving, m),
                                     fixed_.Bounding(fixed, of_fixed, f));
      }
    }
  }

  // Solids that overlap with every vertex and edge on the other's surface: look between the corners, evenly
  // chosen ones if there are many.
  Penetration DeepestMidpoint() const {
    Penetration deepest{corners_.front(), Rational(0)};
    const PointLocator in_moving(moving_.solid), in_fixed(fixed_.solid);
    constexpr size_t kMostCorners = 150;
    const size_t step = 1 + corners_.size() / kMostCorners;
    for (size_t i = 0; i < corners_.size(); i += step) {
      for (size_t j = i + step; j < corners_.size(); j += step) {
        const Vector3 middle = Rational(1, 2) * (corners_[i] + corners_[j]);
        if (in_moving.Locate(middle) != Side::kInside || in_fixed.Locate(middle) != Side::kInside) continue;
        const Rational& known = deepest.squared_depth;
        const Rational depth = std::min(in_moving.SquaredDistanceToSurface(middle, known),
                                        in_fixed.SquaredDistanceToSurface(middle, known));
        if (depth > deepest.squared_depth) deepest = {middle, depth};
      }
    }
    return deepest;
  }

  // Of the contacts at one point, one whose planes include another's is implied by it, and so is a copy.
  void DropImplied() {
    std::map<Vector3, std::vector<size_t>> at;
    const auto& contacts = found_.relation.contacts;
    std::vector<std::set<Vector3>> planes;
    for (const Contact& c : contacts) planes.emplace_back(c.planes.begin(), c.planes.end());
    for (size_t i = 0; i < contacts.size(); ++i) at[contacts[i].point].push_back(i);
    std::vector<char> dropped(contacts.size(), 0);
    for (const auto& [point, here] : at) {
      for (const size_t i : here) {
        for (const size_t j : here) {
          if (i == j || dropped[j] != 0) continue;
          const bool implied =
              std::includes(planes[i].begin(), planes[i].end(), planes[j].begin(), planes[j].end());
          if (implied && (planes[i].size() > planes[j].size() || i > j)) dropped[i] = 1;
        }
      }
    }
    FoundContacts kept;
    for (size_t i = 0; i < contacts.size(); ++i) {
      if (dropped[i] != 0) continue;
      kept.relation.contacts.push_back(contacts[i]);
      kept.elements.push_back(found_.elements[i]);
    }
    found_ = std::move(kept);
  }

  void NameContacts() {
    for (const ContactPrimitive& primitive : found_.primitives) {
      for (const size_t i : primitive.contacts) {
        std::string& name = found_.relation.contacts[i].name;
        if (!name.empty()) name += ", ";
        name += ToString(primitive.moving) + " on " + ToString(primitive.fixed);
      }
    }
  }

  Body moving_, fixed_;
  Rational tolerance_, squared_tolerance_;
  double reach_;           // the tolerance for box tests, rounded up
  bool overlaps_ = false;  // some pieces do, as far as the tolerance can tell
  std::vector<Vector3> corners_;
  FoundContacts found_;
};

}  // namespace

FoundContacts FindContacts(const Polyhedron& moving, const Polyhedron& fixed, const Rational& tolerance) {
  if (tolerance.sign() < 0) throw PreconditionError("a negative tolerance");
  if (auto penetration = FindPenetration(moving, fixed, tolerance)) {
    FoundContacts found;
    found.penetration = std::move(penetration);
    return found;
  }
  return Finder(moving, fixed, tolerance).Run();
}

}  // namespace tact::algebra
