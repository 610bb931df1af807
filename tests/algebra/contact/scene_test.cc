#include "algebra/contact/scene.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

std::vector<Vector3> Corners(const Vector3& low, const Vector3& high) { return Box(low, high).points; }

TEST(Scene, TouchingPiecesAreOneSolid) {
  const Polyhedron angle = UnionOfHulls({Corners({0, 0, 0}, {3, 1, 1}), Corners({0, 0, 1}, {1, 1, 3})});
  EXPECT_EQ(angle.shells, 2u);
  EXPECT_EQ(SixfoldVolume(angle), Rational(30));
}

TEST(Scene, OverlappingFlatOrMissingPiecesAreRefused) {
  EXPECT_THROW(UnionOfHulls({}), PreconditionError);
  EXPECT_THROW(UnionOfHulls({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}), PreconditionError);
  EXPECT_THROW(UnionOfHulls({Corners({0, 0, 0}, {2, 2, 2}), Corners({1, 1, 1}, {3, 3, 3})}),
               PreconditionError);
}

TEST(Scene, APegGoesDownASlotOfPieces) {
  const Scene scene{
      {Corners({0, 0, 0}, {1, 1, 4})},
      {Corners({-2, 0, -3}, {0, 1, -1}), Corners({1, 0, -3}, {3, 1, -1}), Corners({-2, 0, -4}, {3, 1, -3})},
      MotionPath::Line({0, 0, -3})};
  const PathContacts path = FollowScene(scene);
  ASSERT_TRUE(path.event);
  EXPECT_EQ(path.event->parameter.center, Rational(1, 3));  // the tip enters the slot
  Scene inside = scene;
  for (Vector3& p : inside.moving_pieces[0]) p.z = p.z - Rational(3, 2);
  inside.path = MotionPath::Line({0, 0, Rational(-3, 2)});
  const PathContacts in = FollowScene(inside);
  EXPECT_FALSE(in.event) << in.event->what;
  EXPECT_EQ(BriefOf(in.start.relation), "201/102/12");
  EXPECT_EQ(BriefOf(in.end.relation), "111/012/23");
  EXPECT_EQ(in.start.relation.contacts.size(), 8u);  // the corners of two common rectangles
  EXPECT_EQ(in.end.relation.contacts.size(), 12u);   // of three
}

}  // namespace
}  // namespace tact::algebra
