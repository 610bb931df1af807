#include "algebra/contact/singular_edge.h"

#include <gtest/gtest.h>

namespace tact::algebra {
namespace {

// By hand: in the plane across the edges the ends move by u and v, the planes are x and z, so the wedge is the open
// quadrant x < 0, z < 0 and the edge the segment from u to v.
TEST(SingularEdge, OnePlaneForBothEndsSuffices) {
  EXPECT_TRUE(PermitsEdgeMotion({1, -5, 2, -7}));
  EXPECT_TRUE(PermitsEdgeMotion({-5, 0, -7, 0}));
  EXPECT_TRUE(PermitsEdgeMotion({0, 0, 0, 0}));
}

TEST(SingularEdge, AnEndInTheWedgeIsStopped) {
  EXPECT_FALSE(PermitsEdgeMotion({-1, -1, 5, 5}));
  EXPECT_FALSE(PermitsEdgeMotion({5, 5, -1, -1}));
}

// From (1, -3) to (-3, 1) the segment passes (-1, -1); from (3, -1) to (-1, 3) it passes (1, 1).
TEST(SingularEdge, BothEndsMayBeLegalAndTheMiddleNot) {
  EXPECT_FALSE(PermitsEdgeMotion({1, -3, -3, 1}));
  EXPECT_TRUE(PermitsEdgeMotion({3, -1, -1, 3}));
  EXPECT_FALSE(PermitsEdgeMotion({-3, 1, 1, -3}));
  EXPECT_TRUE(PermitsEdgeMotion({-1, 3, 3, -1}));
}

// The segment from (1, -1) to (-1, 1) goes through the corner of the wedge.
TEST(SingularEdge, GrazingTheCornerIsPermitted) {
  EXPECT_TRUE(PermitsEdgeMotion({1, -1, -1, 1}));
  EXPECT_FALSE(PermitsEdgeMotion({1, -1, Rational(-1), Rational(99, 100)}));
  EXPECT_TRUE(PermitsEdgeMotion({1, -1, Rational(-1), Rational(101, 100)}));
}

}  // namespace
}  // namespace tact::algebra
