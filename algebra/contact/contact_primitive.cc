#include <algorithm>
#include <map>
#include <tuple>

#include "algebra/contact/contact_finder.h"

namespace tact::algebra {
namespace {

using Pair = std::pair<Element, Element>;

class Grouping {
 public:
  Grouping(const Polyhedron& moving, const Polyhedron& fixed, const ContactRelation& relation,
           const std::vector<Pair>& elements, const Rational& tolerance)
      : moving_(moving),
        fixed_(fixed),
        relation_(relation),
        elements_(elements),
        squared_tolerance_(tolerance * tolerance) {}

  std::vector<ContactPrimitive> Run() {
    std::map<Pair, std::vector<size_t>> members;
    std::vector<std::vector<Pair>> candidates(relation_.contacts.size());
    for (size_t i = 0; i < relation_.contacts.size(); ++i) {
      candidates[i] = Candidates(i);
      for (const Pair& pair : candidates[i]) members[pair].push_back(i);
    }
    // Each contact belongs to the largest pairs that really share a point, segment or area through it.
    std::map<Pair, std::vector<size_t>> chosen;
    for (size_t i = 0; i < candidates.size(); ++i) {
      int best = 0;
      for (const Pair& pair : candidates[i]) {
        if (Spans(pair, members[pair])) best = std::max(best, Rank(pair));
      }
      for (const Pair& pair : candidates[i]) {
        if (Rank(pair) == best && Spans(pair, members[pair])) chosen[pair].push_back(i);
      }
    }
    std::vector<ContactPrimitive> primitives;
    for (const auto& [pair, contacts] : chosen) primitives.push_back({pair.first, pair.second, contacts});
    std::sort(primitives.begin(), primitives.end(), [](const ContactPrimitive& a, const ContactPrimitive& b) {
      return std::tie(a.contacts.front(), a.moving, a.fixed) <
             std::tie(b.contacts.front(), b.moving, b.fixed);
    });
    return primitives;
  }

 private:
  static int Dimension(const Element& e) { return static_cast<int>(e.kind); }
  // Larger is preferred: the sum of the dimensions; a face beats two edges.
  static int Rank(const Pair& p) {
    const bool has_face = p.first.kind == ElementKind::kFace || p.second.kind == ElementKind::kFace;
    return 1 + 2 * (Dimension(p.first) + Dimension(p.second)) + (has_face ? 1 : 0);
  }

  Vector3 Along(const Polyhedron& solid, size_t e) const {
    return solid.vertices[solid.edges[e].head].point - solid.vertices[solid.edges[e].tail].point;
  }

  // Whether a plane with normal n holds the direction, up to the tolerance over its length.
  bool Holds(const Vector3& n, const Vector3& d) const {
    const Rational height = Dot(n, d);
    return height * height <= squared_tolerance_ * Dot(n, n);
  }

  bool EdgeLiesIn(const Polyhedron& solid, size_t e, const std::vector<Vector3>& planes) const {
    return std::all_of(planes.begin(), planes.end(),
                       [&](const Vector3& n) { return Holds(n, Along(solid, e)); });
  }

  bool FaceLiesIn(const Polyhedron& solid, const Face& face, const Vector3& n) const {
    for (const auto& edges : face.loop_edges) {
      for (const size_t e : edges) {
        if (!Holds(n, Along(solid, e))) return false;
      }
    }
    return true;
  }

  // The element and those around it that lie in all the planes; faces only with their outside to the given
  // side of a single plane.
  std::vector<Element> Around(const Polyhedron& solid, const Element& element,
                              const std::vector<Vector3>& planes, int side) const {
    std::vector<Element> around = {element};
    std::vector<size_t> faces, edges;
    if (element.kind == ElementKind::kVertex) {
      faces = solid.vertices[element.index].faces;
      edges = solid.vertices[element.index].edges;
    } else if (element.kind == ElementKind::kEdge) {
      faces = {solid.edges[element.index].left, solid.edges[element.index].right};
    }
    for (const size_t e : edges) {
      if (EdgeLiesIn(solid, e, planes)) around.push_back({ElementKind::kEdge, e});
    }
    for (const size_t f : faces) {
      if (planes.size() != 1 || Dot(solid.faces[f].normal, planes[0]).sign() != side) continue;
      if (FaceLiesIn(solid, solid.faces[f], planes[0])) around.push_back({ElementKind::kFace, f});
    }
    return around;
  }

  std::vector<Pair> Candidates(size_t i) const {
    const auto& planes = relation_.contacts[i].planes;
    std::vector<Pair> pairs;
    for (const Element& a : Around(moving_, elements_[i].first, planes, -1)) {
      for (const Element& b : Around(fixed_, elements_[i].second, planes, 1)) {
        const Pair pair{a, b};
        const bool edges = a.kind == ElementKind::kEdge && b.kind == ElementKind::kEdge;
        // Edges that cross in a plane are the corner of a larger contact, unless they are all there is.
        if (edges && pair != elements_[i] && !Parallel(Along(moving_, a.index), Along(fixed_, b.index)))
          continue;
        pairs.push_back(pair);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
  }

  // Whether the contacts of a pair span what such a pair shares: an area, a segment, a point.
  bool Spans(const Pair& pair, const std::vector<size_t>& members) const {
    const auto& [a, b] = pair;
    const int wanted = a.kind == ElementKind::kEdge && b.kind == ElementKind::kEdge
                           ? (Parallel(Along(moving_, a.index), Along(fixed_, b.index)) ? 1 : 0)
                           : std::min(Dimension(a), Dimension(b));
    const Vector3& first = relation_.contacts[members[0]].point;
    Vector3 direction;
    int spanned = 0;
    for (const size_t i : members) {
      const Vector3 d = relation_.contacts[i].point - first;
      if (spanned == 0 && !d.IsZero()) {
        direction = d;
        spanned = 1;
      } else if (spanned == 1 && !Parallel(d, direction)) {
        spanned = 2;
      }
    }
    return spanned >= wanted;
  }

  const Polyhedron& moving_;
  const Polyhedron& fixed_;
  const ContactRelation& relation_;
  const std::vector<Pair>& elements_;
  Rational squared_tolerance_;
};

}  // namespace

std::string KindOf(const ContactPrimitive& primitive) {
  static const char* const kNames[] = {"vertex", "edge", "face"};
  return std::string(kNames[static_cast<int>(primitive.moving.kind)]) + "-" +
         kNames[static_cast<int>(primitive.fixed.kind)];
}

std::vector<ContactPrimitive> GroupIntoPrimitives(const Polyhedron& moving, const Polyhedron& fixed,
                                                  const ContactRelation& relation,
                                                  const std::vector<Pair>& elements,
                                                  const Rational& tolerance) {
  return Grouping(moving, fixed, relation, elements, tolerance).Run();
}

}  // namespace tact::algebra
