#include "robot/recognition/element_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/robot/recognition/solids.h"

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

constexpr double kTilt = 0.1;

// A cube of side 2 over a plate of 8 x 8 x 2, 0.25 apart: by hand, its four lower corners and the plate's upper face.
TEST(ElementDistance, ACubeOverAPlateIsFourCornersNearOneFace) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near = NearPairs(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 2.25}}, 0.5, kTilt);
  ASSERT_EQ(near.size(), 4U);
  for (const NearPair& pair : near) {
    EXPECT_EQ(pair.contact.kind, PointContactKind::kVertexFace);
    EXPECT_NEAR(pair.distance, 0.25, 1e-12);
    EXPECT_NEAR(pair.gap, 0.25, 1e-12);
    EXPECT_NEAR(plate.solid().faces[pair.contact.fixed].normal.z(), 1, 1e-12);
  }
  EXPECT_TRUE(NearPairs(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 2.75}}, 0.5, kTilt).empty());
}

// Pushed in by 0.25 the same corners touch, with a negative gap.
TEST(ElementDistance, OverlapIsANegativeGap) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near = NearPairs(cube, plate, {Eigen::Matrix3d::Identity(), {0.5, 0, 1.75}}, 0.5, kTilt);
  ASSERT_EQ(near.size(), 4U);
  for (const NearPair& pair : near) EXPECT_NEAR(pair.gap, -0.25, 1e-12);
}

// Half beyond the rim, 0.2 above it: by hand, two corners over the plate and two crossings of the rim with the cube's lower
// edges; the cube's outer corners are 1.1 away from the rim.
TEST(ElementDistance, BeyondTheRimTheCrossingsCount) {
  const ProximitySolid cube(Box(1, 1, 1)), plate(Box(4, 4, 1));
  const auto near = NearPairs(cube, plate, {Eigen::Matrix3d::Identity(), {4.1, 0, 2.2}}, 0.5, kTilt);
  ASSERT_EQ(near.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(near[i].contact.kind, i < 2 ? PointContactKind::kVertexFace : PointContactKind::kEdgeEdge);
    EXPECT_NEAR(near[i].gap, 0.2, 1e-12);
  }
  const auto over = NearPairs(cube, plate, {Eigen::Matrix3d::Identity(), {5.3, 0, 1.1}}, 0.5, kTilt);
  // Beside the plate: its side faces the cube's, 0.3 away.
  for (const NearPair& pair : over) EXPECT_NEAR(pair.gap, 0.3, 1e-12);
  EXPECT_FALSE(over.empty());
}

// Two bars crossing at a right angle, an edge down on an edge up: both turned by an eighth about their length.
TEST(ElementDistance, CrossingEdgesAreOnePair) {
  const ProximitySolid lower(Box(5, 1, 1)), upper(Box(1, 5, 1));
  const Transform X_WL{joint::RotationExp({M_PI / 4, 0, 0}), {0, 0, 0}};
  const Transform X_WU{joint::RotationExp({0, M_PI / 4, 0}), {0.5, 0.25, 2 * std::sqrt(2) + 0.125}};
  const auto near = NearPairs(upper, lower, X_WL.Inverse() * X_WU, 0.5, kTilt);
  ASSERT_EQ(near.size(), 1U);
  EXPECT_EQ(near[0].contact.kind, PointContactKind::kEdgeEdge);
  EXPECT_NEAR(near[0].gap, 0.125, 1e-12);
  EXPECT_NEAR(near[0].distance, 0.125, 1e-12);
  // GapOf agrees in size and sign.
  EXPECT_NEAR(GapOf(near[0].contact, upper.solid(), lower.solid(), X_WL.Inverse() * X_WU).gap, 0.125, 1e-12);
}

TEST(ElementDistance, DepthIsToTheNearestFaceAndZeroOutside) {
  const ProximitySolid box(Box(4, 4, 1));
  EXPECT_NEAR(box.DepthOf({0.3, -0.2, 0.6}), 0.4, 1e-12);
  EXPECT_NEAR(box.DepthOf({3.9, 0, 0}), 0.1, 1e-12);
  EXPECT_EQ(box.DepthOf({4.1, 0, 0}), 0);
  EXPECT_EQ(box.DepthOf({0, 0, 30}), 0);
}

TEST(ElementDistance, SegmentsByHand) {
  EXPECT_NEAR(DistanceOfSegments({0, 0, 0}, {2, 0, 0}, {1, -1, 3}, {1, 1, 3}), 3, 1e-12);
  EXPECT_NEAR(DistanceOfSegments({0, 0, 0}, {2, 0, 0}, {5, 4, 0}, {9, 4, 0}), 5, 1e-12);
  EXPECT_NEAR(DistanceOfSegments({0, 0, 0}, {2, 0, 0}, {1, 2, 0}, {9, 2, 0}), 2, 1e-12);
}

}  // namespace
}  // namespace tact::recognition
