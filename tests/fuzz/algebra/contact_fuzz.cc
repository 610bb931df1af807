/// @file
/// Bytes become two solids of small boxes in place. Their motion DOFs do not change when both move together, nor
/// when the two change roles: the rows are the same, only named from the other side.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/solid/polyhedron.h"
#include "tests/algebra/solid/solids.h"

namespace tact::algebra {
namespace {

// The next byte as a small integer from low to high; low when there are no more.
class Bytes {
 public:
  Bytes(const uint8_t* data, size_t size) : data_(data), size_(size) {}
  int Next(int low, int high) { return at_ < size_ ? low + data_[at_++] % (high - low + 1) : low; }

 private:
  const uint8_t* data_;
  size_t size_, at_ = 0;
};

PolygonSoup NextBox(Bytes& bytes) {
  const int x = bytes.Next(-3, 3), y = bytes.Next(-3, 3), z = bytes.Next(-3, 3);
  const Vector3 low{x, y, z};
  return Box(low, low + Vector3{bytes.Next(1, 4), bytes.Next(1, 4), bytes.Next(1, 4)});
}

// One or two boxes; none if the two are no solid together.
std::optional<Polyhedron> NextSolid(Bytes& bytes) {
  PolygonSoup soup = NextBox(bytes);
  if (bytes.Next(0, 1) == 1) soup = soup + NextBox(bytes);
  try {
    return BuildPolyhedron(soup);
  } catch (const SoupError&) {
    return std::nullopt;
  }
}

// Half of all translations and a third of all rotations are of a kind that leaves flat sides on each other.
Pose NextPose(Bytes& bytes) {
  Pose pose;
  const int kind = bytes.Next(0, 2), q1 = bytes.Next(-2, 2), q2 = bytes.Next(-2, 2), q3 = bytes.Next(-2, 2);
  if (kind == 1)
    pose.rotation = Rotation::FromQuaternion(Rational(1), Rational(0), Rational(0), Rational(q1));
  if (kind == 2) {
    pose.rotation = Rotation::FromQuaternion(Rational(3), Rational(q1), Rational(q2), Rational(q3));
  }
  const int parts = bytes.Next(1, 2);
  for (int i = 0; i < 3; ++i) pose.translation[i] = Rational(bytes.Next(-6, 6), parts);
  return pose;
}

// None if the solids interpenetrate.
std::optional<MotionDof> DofOf(const Polyhedron& moving, const Polyhedron& fixed, const Rational& tolerance) {
  const FoundContacts found = FindContacts(moving, fixed, tolerance);
  if (found.penetration) return std::nullopt;
  return ComputeMotionDof(found.relation);
}

void Try(Bytes bytes) {
  const auto model = NextSolid(bytes), fixed = NextSolid(bytes);
  if (!model || !fixed) return;
  const Polyhedron moving = Transform(*model, NextPose(bytes));
  const Pose together = NextPose(bytes);
  const Rational tolerance(bytes.Next(0, 2), 8);
  const auto dof = DofOf(moving, *fixed, tolerance);
  if (DofOf(Transform(moving, together), Transform(*fixed, together), tolerance) != dof) std::abort();
  // Across a gap the contact's point is that of one of the two.
  if (tolerance.sign() == 0 && DofOf(*fixed, moving, tolerance) != dof) std::abort();
}

}  // namespace
}  // namespace tact::algebra

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  tact::algebra::Try(tact::algebra::Bytes(data, size));
  return 0;
}
