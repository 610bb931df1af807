#include "robot/recognition/transition_validity.h"

#include <algorithm>

namespace tact::recognition {
namespace {

using algebra::ContactPrimitive;
using algebra::Element;
using algebra::ElementKind;
using algebra::Polyhedron;

bool Has(const std::vector<size_t>& list, size_t index) {
  return std::find(list.begin(), list.end(), index) != list.end();
}

// Whether the first is the second or in its boundary.
bool IsIn(const Polyhedron& solid, const Element& small, const Element& large) {
  if (small == large) return true;
  if (small.kind == ElementKind::kVertex) {
    const algebra::Vertex& vertex = solid.vertices[small.index];
    return (large.kind == ElementKind::kEdge && Has(vertex.edges, large.index)) ||
           (large.kind == ElementKind::kFace && Has(vertex.faces, large.index));
  }
  return small.kind == ElementKind::kEdge && large.kind == ElementKind::kFace &&
         (solid.edges[small.index].left == large.index || solid.edges[small.index].right == large.index);
}

bool Meet(const Polyhedron& solid, const Element& a, const Element& b) {
  return IsIn(solid, a, b) || IsIn(solid, b, a);
}

bool Includes(const Primitives& all, const Primitives& some, const Polyhedron& moving,
              const Polyhedron& fixed) {
  return std::all_of(some.begin(), some.end(), [&](const ContactPrimitive& one) {
    return std::any_of(all.begin(), all.end(), [&](const ContactPrimitive& other) {
      return Meet(moving, one.moving, other.moving) && Meet(fixed, one.fixed, other.fixed);
    });
  });
}

}  // namespace

bool SameElements(const Primitives& a, const Primitives& b) {
  return std::is_permutation(a.begin(), a.end(), b.begin(), b.end(), [](const auto& p, const auto& q) {
    return p.moving == q.moving && p.fixed == q.fixed;
  });
}

TransitionValidity ValidityOf(const RelationToCheck& from, const RelationToCheck& to,
                              const Polyhedron& moving, const Polyhedron& fixed) {
  return {Includes(from.primitives, to.primitives, moving, fixed) ||
              Includes(to.primitives, from.primitives, moving, fixed),
          AnalyzeTransition(from.dof, to.dof).practical};
}

std::string ToString(const TransitionValidity& validity) {
  std::string text;
  if (!validity.included) text = "neither relation includes the other";
  if (!validity.practical) text += (text.empty() ? "" : "; ") + std::string("no practical DOF-transition");
  return text;
}

}  // namespace tact::recognition
