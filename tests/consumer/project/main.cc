/// @file
/// A project of somebody else's that uses the installed tact::algebra.
#include <iostream>

#include "algebra/contact/contact_relation.h"
#include "algebra/screw/pose.h"
#include "algebra/solid/polyhedron.h"

int main() {
  using namespace tact::algebra;
  const Rational sum = Rational(1, 3) + Rational(1, 6);
  const Vector3 normal = Cross({1, 0, 0}, {0, sum, 0});
  const Vector3 turned = Rotation::FromQuaternion(1, 1, 0, 0) * normal;
  std::cout << sum.ToString() << "\n" << ToString(normal) << "\n" << ToString(turned) << "\n";
}
