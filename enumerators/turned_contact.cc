#include "enumerators/turned_contact.h"

#include <algorithm>
#include <array>
#include <set>

namespace tact::enumerators {
namespace {

using algebra::Contact;
using algebra::MotionPath;
using algebra::Polyhedron;
using algebra::Rational;
using algebra::Vector3;

// The second where something is in the way of the first.
const std::array<Rational, 2>& Tangents() {
  static const std::array<Rational, 2> tangents = {Rational(1, 5), Rational(1, 20)};
  return tangents;
}

Vector3 AxisVector(int axis, const Rational& length) {
  Vector3 v;
  v[axis] = length;
  return v;
}

// Lines along the axis through contacting points, a point each: the one at height zero.
std::set<Vector3> Centers(const algebra::ContactRelation& relation, int axis) {
  std::set<Vector3> centers;
  for (const Contact& contact : relation.contacts) {
    Vector3 center = contact.point;
    center[axis] = 0;
    centers.insert(center);
  }
  return centers;
}

// Whether every contact permits the start of the turn.
bool Permitted(const algebra::ContactRelation& relation, const Vector3& center, const Vector3& spin) {
  return std::all_of(relation.contacts.begin(), relation.contacts.end(), [&](const Contact& contact) {
    const Vector3 velocity = Cross(spin, contact.point - center);
    return std::any_of(contact.planes.begin(), contact.planes.end(),
                       [&](const Vector3& normal) { return Dot(normal, velocity).sign() >= 0; });
  });
}

class Search {
 public:
  Search(const Polyhedron& moving, const Polyhedron& fixed, const FormationComplex& complex)
      : moving_(moving), fixed_(fixed), complex_(complex) {}

  TurnedContacts Run() {
    for (size_t border = 0; border < complex_.formations.size(); ++border) {
      const algebra::ContactRelation& relation = complex_.formations[border].relation;
      known_ = {complex_.formations[border].pairs};
      for (int axis = 0; axis < 3; ++axis) {
        for (const Vector3& center : Centers(relation, axis)) {
          for (const int sign : {1, -1}) {
            if (Permitted(relation, center, AxisVector(axis, sign))) Try(border, center, axis, sign);
          }
        }
      }
    }
    return std::move(result_);
  }

 private:
  void Try(size_t border, const Vector3& center, int axis, int sign) {
    bool decided = true;
    for (const Rational& size : Tangents()) {
      const Turn turn{center, axis, Rational(sign) * size};
      const Polyhedron turned = Transform(moving_, TurnedPose(complex_.formations[border].pose, turn));
      algebra::FoundContacts open = FindContacts(turned, fixed_, 0);
      if (open.penetration) continue;
      ElementPairs pairs = PairsOf(open);
      if (known_.count(pairs) != 0) return;
      const auto path =
          FollowPath(turned, fixed_, MotionPath::Rotation(center, AxisVector(axis, -turn.tangent)));
      decided = !path.event || path.event->parameter.is_rational();
      if (path.event) continue;
      known_.insert(std::move(pairs));
      result_.found.push_back({border, turn, std::move(open)});
      return;
    }
    result_.undecided += decided ? 0 : 1;
  }

  const Polyhedron& moving_;
  const Polyhedron& fixed_;
  const FormationComplex& complex_;
  std::set<ElementPairs> known_;  // that some tilt out of the formation has
  TurnedContacts result_;
};

}  // namespace

MotionPath PathOf(const Turn& turn) {
  return MotionPath::Rotation(turn.center, AxisVector(turn.axis, turn.tangent));
}

algebra::Pose TurnedPose(const Vector3& translation, const Turn& turn) {
  return PathOf(turn).At(1) * algebra::Pose{{}, translation};
}

TurnedContacts FindTurnedContacts(const Polyhedron& moving, const Polyhedron& fixed,
                                  const FormationComplex& complex) {
  return Search(moving, fixed, complex).Run();
}

}  // namespace tact::enumerators
