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

const std::array<Rational, 3>& Tangents() {
  static const std::array<Rational, 3> tangents = {Rational(1, 2), Rational(1, 5), Rational(1, 20)};
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

}  // namespace

algebra::Pose TurnedPose(const Vector3& translation, const Turn& turn) {
  return MotionPath::Rotation(turn.center, AxisVector(turn.axis, turn.tangent)).At(1) *
         algebra::Pose{{}, translation};
}

TurnedContacts FindTurnedContacts(const Polyhedron& moving, const Polyhedron& fixed,
                                  const FormationComplex& complex) {
  TurnedContacts result;
  for (size_t border = 0; border < complex.formations.size(); ++border) {
    const Formation& formation = complex.formations[border];
    std::set<ElementPairs> known = {formation.pairs};
    for (int axis = 0; axis < 3; ++axis) {
      for (const Vector3& center : Centers(formation.relation, axis)) {
        for (const int sign : {1, -1}) {
          if (!Permitted(formation.relation, center, AxisVector(axis, sign))) continue;
          for (const Rational& size : Tangents()) {
            const Turn turn{center, axis, Rational(sign) * size};
            const Polyhedron turned = Transform(moving, TurnedPose(formation.pose, turn));
            if (FindPenetration(turned, fixed, 0)) continue;
            const algebra::PathContacts path =
                FollowPath(turned, fixed, MotionPath::Rotation(center, AxisVector(axis, -turn.tangent)));
            if (path.event) {
              result.undecided += path.event->parameter.is_rational() ? 0 : 1;
              continue;
            }
            if (known.insert(PairsOf(path.middle)).second) {
              result.found.push_back(
                  {border, turn, path.middle.relation, ComputeMotionDof(path.middle.relation)});
            }
            break;
          }
        }
      }
    }
  }
  return result;
}

}  // namespace tact::enumerators
