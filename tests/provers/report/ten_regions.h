/// @file
/// Contact normals for each of the ten regions of legal directions, found by hand.
#pragma once

#include <vector>

#include "provers/report/sphere_region.h"

namespace tact::provers {

inline algebra::ContactRelation Normals(const std::vector<algebra::Vector3>& normals) {
  algebra::ContactRelation relation;
  for (const algebra::Vector3& n : normals) relation.contacts.push_back({{0, 0, 0}, {n}, ""});
  return relation;
}

struct RegionExample {
  std::vector<algebra::Vector3> normals;
  SphereRegion region;
  const char* name;
};

inline std::vector<RegionExample> TenRegions() {
  return {
      {{}, SphereRegion::kWholeSphere, "whole sphere"},
      {{{0, 0, 1}}, SphereRegion::kHemisphere, "hemisphere"},
      {{{0, 0, 1}, {1, 0, 0}}, SphereRegion::kLune, "lune"},
      {{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, 1, 2}}, SphereRegion::kConvexPolygon, "convex polygon"},
      {{{0, 0, 1}, {0, 0, -1}}, SphereRegion::kGreatCircle, "great circle"},
      {{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}}, SphereRegion::kHalfCircle, "half circle"},
      {{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {1, 1, 0}}, SphereRegion::kArc, "arc"},
      {{{0, 0, 1}, {0, 0, -1}, {1, 0, 0}, {-1, 0, 0}}, SphereRegion::kOppositePoints, "two opposite points"},
      {{{1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}, {0, 0, 1}}, SphereRegion::kPoint, "point"},
      {{{1, 1, 1}, {-1, -1, 1}, {1, -1, -1}, {-1, 1, -1}}, SphereRegion::kNothing, "nothing"},
  };
}

}  // namespace tact::provers
