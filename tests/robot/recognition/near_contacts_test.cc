#include "robot/recognition/near_contacts.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/recognition/solids.h"

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

constexpr double kTilt = 0.1;

// A cube of side 2 over a plate of 8 x 8 x 2, 0.25 apart: by hand, its four lower corners and the plate's upper face.
TEST(NearContacts, ACubeOverAPlateIsFourCornersNearOneFace) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near =
      FindNearContacts(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 2.25}}, {0.5, kTilt});
  ASSERT_EQ(near.size(), 4U);
  for (const NearContact& pair : near) {
    EXPECT_EQ(pair.contact.kind, PointContactKind::kVertexFace);
    EXPECT_EQ(pair.aside, 0);
    EXPECT_NEAR(pair.gap, 0.25, 1e-12);
    EXPECT_NEAR(plate.solid().faces[pair.contact.fixed].normal.z(), 1, 1e-12);
  }
  EXPECT_TRUE(
      FindNearContacts(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 2.75}}, {0.5, kTilt}).empty());
}

// Pushed in by 0.25 the same corners touch, with a negative gap.
TEST(NearContacts, OverlapIsANegativeGap) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near =
      FindNearContacts(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 1.75}}, {0.5, kTilt});
  ASSERT_EQ(near.size(), 4U);
  for (const NearContact& pair : near) EXPECT_NEAR(pair.gap, -0.25, 1e-12);
}

// Half beyond the rim, 0.2 above it: by hand, two corners over the plate and two crossings of the rim with the cube's lower
// edges; the cube's outer corners are 1.1 away from the rim.
TEST(NearContacts, BeyondTheRimTheCrossingsCount) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near = FindNearContacts(cube, plate, {Eigen::Matrix3d::Identity(), {4.1, 0, 2.2}}, {0.5, kTilt});
  ASSERT_EQ(near.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(near[i].contact.kind, i < 2 ? PointContactKind::kVertexFace : PointContactKind::kEdgeEdge);
    EXPECT_NEAR(near[i].gap, 0.2, 1e-12);
  }
  const auto over = FindNearContacts(cube, plate, {Eigen::Matrix3d::Identity(), {5.3, 0, 1.1}}, {0.5, kTilt});
  // Beside the plate: its side faces the cube's, 0.3 away.
  for (const NearContact& pair : over) EXPECT_NEAR(pair.gap, 0.3, 1e-12);
  EXPECT_FALSE(over.empty());
}

// Two bars crossing at a right angle, an edge down on an edge up: both turned by an eighth about their length.
TEST(NearContacts, CrossingEdgesAreOnePair) {
  const ProximitySolid lower(Box(5, 1, 1)), upper(Box(1, 5, 1));
  const Transform X_WL{joint::RotationExp({M_PI / 4, 0, 0}), {0, 0, 0}};
  const Transform X_WU{joint::RotationExp({0, M_PI / 4, 0}), {0.5, 0.25, 2 * std::sqrt(2) + 0.125}};
  const auto near = FindNearContacts(upper, lower, X_WL.Inverse() * X_WU, {0.5, kTilt});
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].contact.kind, PointContactKind::kEdgeEdge);
  EXPECT_NEAR(near[0].gap, 0.125, 1e-12);
  EXPECT_EQ(near[0].aside, 0);
  // GapOf agrees in size and sign.
  EXPECT_NEAR(GapOf(near[0].contact, upper.solid(), lower.solid(), X_WL.Inverse() * X_WU).gap, 0.125, 1e-12);
}

TEST(NearContacts, DepthIsToTheNearestFaceAndZeroOutside) {
  const ProximitySolid box(Box(4, 4, 1));
  EXPECT_NEAR(box.DepthOf({0.3, -0.2, 0.6}), 0.4, 1e-12);
  EXPECT_NEAR(box.DepthOf({3.9, 0, 0}), 0.1, 1e-12);
  EXPECT_EQ(box.DepthOf({4.1, 0, 0}), 0);
  EXPECT_EQ(box.DepthOf({0, 0, 30}), 0);
}

// By hand: 0.3 beyond the rim and 0.4 above the plane, 0.5 from the rim.
TEST(NearContacts, BesideAFaceTheRimIsNearest) {
  const ProximitySolid plate(Box(4, 4, 1));
  for (size_t f = 0; f < plate.solid().faces.size(); ++f) {
    if (plate.solid().faces[f].normal.z() < 0.5) continue;
    EXPECT_NEAR(plate.AsideOfFace(f, {4.3, 1, 1.4}), 0.3, 1e-12);
    EXPECT_NEAR(plate.DistanceToFace(f, {4.3, 1, 1.4}), 0.5, 1e-12);
    EXPECT_EQ(plate.AsideOfFace(f, {3.9, 1, 1.4}), 0);
  }
  EXPECT_NEAR(plate.diameter(), std::sqrt(132), 1e-12);
  EXPECT_EQ(plate.middle(), Vector3d(0, 0, 0));
}

}  // namespace
}  // namespace tact::recognition
