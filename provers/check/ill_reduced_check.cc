// A parallel edge-edge contact where the reduction to its two ends admits a motion that the contact forbids
// between.
#include <array>

#include "provers/check/exact_rank.h"
#include "provers/check/kinds.h"

namespace tact::check {
namespace {

mpz_class Dot(const Row& a, const Row& b) {
  mpz_class sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += a[i] * b[i];
  return sum;
}

// W times the velocity of the point (X/W, Y/W, Z/W) under the motion [ w ; v ]: w x (X, Y, Z) + W v.
Row ScaledVelocity(const Row& motion, const Row& point) {
  Row velocity(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    velocity[i] = motion[j] * point[k] - motion[k] * point[j] + point[3] * motion[3 + i];
  }
  return velocity;
}

template <std::size_t count>
std::array<Row, count> ReadRows(const Value& list, std::size_t width) {
  const Array& array = AsArray(list);
  if (array.size() != count) throw Refused(&list, "expected " + std::to_string(count) + " entries");
  std::array<Row, count> rows;
  for (std::size_t i = 0; i < count; ++i) rows[i] = AsIntegers(array[i], width);
  return rows;
}

}  // namespace

void CheckIllReducedSingular(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"ends", "planes", "motion", "between"});
  const Value& ends = At(certificate, "ends");
  const Value& planes = At(certificate, "planes");
  const auto points = ReadRows<2>(ends, 4);
  const auto normals = ReadRows<2>(planes, 3);
  const Row motion = AsIntegers(At(certificate, "motion"), 6);
  const Row between = AsIntegers(At(certificate, "between"), 2);

  for (std::size_t i = 0; i < 2; ++i) {
    if (points[i][3] <= 0) throw Refused(&AsArray(ends)[i], "W is not positive");
    if (between[i] <= 0) throw Refused(&At(certificate, "between"), "the point is not between the ends");
  }
  Row edge(3);
  for (std::size_t i = 0; i < 3; ++i) edge[i] = points[1][i] * points[0][3] - points[0][i] * points[1][3];
  for (std::size_t i = 0; i < 2; ++i) {
    if (Rank({normals[i]}) == 0) throw Refused(&AsArray(planes)[i], "zero normal");
    if (Dot(normals[i], edge) != 0) throw Refused(&AsArray(planes)[i], "the plane does not hold the edge");
  }

  const std::array<Row, 2> velocities = {ScaledVelocity(motion, points[0]),
                                         ScaledVelocity(motion, points[1])};
  for (std::size_t i = 0; i < 2; ++i) {
    if (Dot(normals[0], velocities[i]) < 0 && Dot(normals[1], velocities[i]) < 0) {
      throw Refused(&AsArray(ends)[i], "the motion is forbidden at this end already");
    }
    // The velocity is affine along the edge: between the ends it is (s v(P) + t v(Q)) / (s + t).
    const mpz_class here = between[0] * points[1][3] * Dot(normals[i], velocities[0]) +
                           between[1] * points[0][3] * Dot(normals[i], velocities[1]);
    if (here >= 0) throw Refused(&AsArray(planes)[i], "the plane admits the motion between the ends");
  }
}

}  // namespace tact::check
