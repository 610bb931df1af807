#include "algebra/contact/motion_path.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "algebra/contact/path_polynomial.h"
#include "algebra/error.h"
#include "tests/algebra/contact/touching_solids.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

Polyhedron Solid(const PolygonSoup& soup) { return BuildPolyhedron(soup); }

std::multiset<std::string> KindsOf(const FoundContacts& found) {
  std::multiset<std::string> kinds;
  for (const ContactPrimitive& primitive : found.primitives) kinds.insert(KindOf(primitive));
  return kinds;
}
using Kinds = std::multiset<std::string>;

std::string Why(const PathContacts& path) { return path.event ? path.event->what : ""; }

TEST(MotionPath, APathWithoutDirectionOrAxisIsRefused) {
  EXPECT_THROW(MotionPath::Line({0, 0, 0}), PreconditionError);
  EXPECT_THROW(MotionPath::Rotation({1, 2, 3}, {0, 0, 0}), PreconditionError);
}

TEST(MotionPath, ARotationKeepsItsAxisAndTurnsByTwiceTheArcTangent) {
  const MotionPath path = MotionPath::Rotation({1, 0, 0}, {0, 0, 1});
  EXPECT_EQ(path.At(0), Pose{});
  EXPECT_EQ(path.At(1) * Vector3(1, 0, 5), Vector3(1, 0, 5));
  EXPECT_EQ(path.At(1) * Vector3(2, 0, 0), Vector3(1, 1, 0));  // tan 45 degrees = 1
  EXPECT_EQ(path.At(Rational(1, 2)) * Vector3(2, 0, 0), Vector3(Rational(8, 5), Rational(4, 5), 0));
}

TEST(FollowPath, ABlockDropsOnATable) {
  const PathContacts path = FollowPath(Solid(Box({0, 0, 2}, {1, 1, 3})), Solid(Box({-3, -3, -1}, {3, 3, 0})),
                                       MotionPath::Line({0, 0, -2}));
  EXPECT_EQ(Why(path), "");
  EXPECT_TRUE(path.start.relation.contacts.empty());
  EXPECT_TRUE(path.middle.relation.contacts.empty());
  EXPECT_EQ(KindsOf(path.end), Kinds{"face-face"});
}

// The block's face stays on the table's until only their borders meet.
TEST(FollowPath, ABlockSlidesOverTheBorderOfATable) {
  const PathContacts path =
      FollowPath(Solid(Box({-1, -1, 0}, {1, 1, 1})), Solid(Box({-3, -3, -1}, {Rational(1, 2), 3, 0})),
                 MotionPath::Line({Rational(3, 2), 0, 0}));
  EXPECT_EQ(Why(path), "");
  EXPECT_EQ(BriefOf(path.start.relation), "210/120/12");
  EXPECT_EQ(BriefOf(path.middle.relation), "210/120/12");
  EXPECT_TRUE(path.end.relation.singular());
  EXPECT_EQ(KindsOf(path.end), Kinds{"edge-edge"});
}

// Upright at the end, 2/5 short of the walls at the start: cos(2 arctan(1/3)) = 4/5. The gap is of second order
// at the end.
TEST(FollowPath, ABarTurnsUntilBothTipsTouchTheWalls) {
  const Pose tilt{Rotation::FromQuaternion(3, 0, 0, -1), {}};
  const PolygonSoup tips = Prism({{0, -2}, {Rational(1, 4), 0}, {0, 2}, {Rational(-1, 4), 0}}, 0, 1);
  const Polyhedron walls = Solid(Box({-9, 2, 0}, {9, 3, 1}) + Box({-9, -3, 0}, {9, -2, 1}));
  const PathContacts path = FollowPath(Transform(Solid(tips), tilt), walls,
                                       MotionPath::Rotation({0, 0, 0}, {0, 0, Rational(1, 3)}));
  EXPECT_EQ(Why(path), "");
  EXPECT_TRUE(path.start.relation.contacts.empty());
  EXPECT_TRUE(path.middle.relation.contacts.empty());
  EXPECT_EQ(KindsOf(path.end), (Kinds{"edge-face", "edge-face"}));
}

TEST(FollowPath, ATiltedBlockTurnsAboutItsBottomEdgeUntilItsFaceLiesDown) {
  const Pose tilt{Rotation::FromQuaternion(2, 0, -1, 0), {}};
  const Polyhedron block = Transform(Solid(Box({0, 0, 0}, {2, 1, 1})), tilt);
  const PathContacts path = FollowPath(block, Solid(Box({-3, -3, -1}, {3, 3, 0})),
                                       MotionPath::Rotation({0, 0, 0}, {0, Rational(1, 2), 0}));
  EXPECT_EQ(Why(path), "");
  EXPECT_EQ(KindsOf(path.start), Kinds{"edge-face"});
  EXPECT_EQ(KindsOf(path.middle), Kinds{"edge-face"});
  EXPECT_EQ(KindsOf(path.end), Kinds{"face-face"});
}

TEST(FollowPath, APathThroughTheTableIsRefusedWithAPointAndTheElementsThatMetFirst) {
  const PathContacts path = FollowPath(Solid(Box({0, 0, 2}, {1, 1, 3})), Solid(Box({-3, -3, -1}, {3, 3, 0})),
                                       MotionPath::Line({0, 0, Rational(-5, 2)}));
  ASSERT_TRUE(path.event);
  EXPECT_EQ(path.event->parameter.center, Rational(4, 5));
  ASSERT_TRUE(path.event->elements);
  EXPECT_EQ(path.event->elements->first.kind, ElementKind::kVertex);
  EXPECT_EQ(path.event->elements->second.kind, ElementKind::kFace);
}

// Across a thin wall: neither end, nor the middle, shows it.
TEST(FollowPath, AJumpThroughAThinWallIsSeen) {
  const PathContacts path =
      FollowPath(Solid(Box({0, 0, 0}, {1, 1, 1})),
                 Solid(Box({Rational(13, 2), -3, -3}, {Rational(33, 5), 3, 3})), MotionPath::Line({8, 0, 0}));
  ASSERT_TRUE(path.event);
  EXPECT_FALSE(path.start.penetration || path.middle.penetration || path.end.penetration);
  EXPECT_EQ(path.event->parameter.center, Rational(11, 16));
}

TEST(FollowPath, ACornerThatLeavesTheTableInTheMiddleIsNamed) {
  const PathContacts path = FollowPath(Solid(Box({0, 0, 0}, {1, 1, 1})), Solid(Box({-3, -3, -1}, {2, 3, 0})),
                                       MotionPath::Line({2, 0, 0}));
  ASSERT_TRUE(path.event);
  EXPECT_EQ(path.event->parameter.center, Rational(1, 2));
  EXPECT_NE(path.event->what.find("touch"), std::string::npos);
}

TEST(FollowPath, ATouchThatIsLostAtOnceIsAnEventAtTheStart) {
  const PathContacts path = FollowPath(Solid(Box({0, 0, 0}, {1, 1, 1})), Solid(Box({-3, -3, -1}, {2, 3, 0})),
                                       MotionPath::Line({0, 0, 1}));
  ASSERT_TRUE(path.event);
  EXPECT_EQ(path.event->parameter.center, Rational(0));
}

// The corner (1, 0, 0) of a block turned about its other edge passes the plane of the shelf's front at an
// irrational parameter, far from the shelf itself.
TEST(FollowPath, AnIrrationalCrossingOfAPlaneFarFromItsFaceIsNoEvent) {
  const Polyhedron block = Solid(Box({0, 0, 0}, {1, 1, 1}));
  const Polyhedron shelf = Solid(Box({Rational(3, 4), -1, 2}, {3, 2, 3}));
  const MotionPath turn = MotionPath::Rotation({0, 0, 0}, {0, Rational(1, 2), 0});
  bool irrational = false;
  for (const Vertex& v : block.vertices) {
    for (const Face& f : shelf.faces) {
      for (const auto& root : RootsInside(HeightAlong(turn, v.point, f.normal, f.offset)))
        irrational = irrational || !root.is_rational();
    }
  }
  EXPECT_TRUE(irrational);
  EXPECT_EQ(Why(FollowPath(block, shelf, turn)), "");
}

TEST(FollowPath, AnIrrationalTouchIsReportedAsSuch) {
  // The corner (2, 0) rises to height 1 at tan(angle) with sin = 1/2.
  const PathContacts path =
      FollowPath(Solid(Prism({{0, 0}, {2, 0}, {0, 1}}, 0, 1)), Solid(Box({-5, 1, -1}, {5, 2, 2})),
                 MotionPath::Rotation({0, 0, 0}, {0, 0, Rational(1, 2)}));
  ASSERT_TRUE(path.event);
  EXPECT_FALSE(path.event->parameter.is_rational());
  EXPECT_NEAR(2 * std::atan(ToDouble(path.event->parameter) / 2), std::asin(0.5), 1e-9);
}

MotionPath AnyPath(Dice& dice) {
  for (;;) {
    const Vector3 v = Rational(1, dice.Roll(1, 6)) * dice.RollVector(-3, 3);
    if (v.IsZero()) continue;
    return dice.Roll(0, 1) == 0 ? MotionPath::Line(v) : MotionPath::Rotation(dice.RollVector(-2, 2), v);
  }
}

// Laws of the polynomials against the pose itself.
RC_GTEST_PROP(PathPolynomial, HeightsAndMeetingsAreThoseOfThePoseTimesTheWeight, ()) {
  Dice dice(Uniform(0u, 1u << 30));
  const MotionPath path = AnyPath(dice);
  const Vector3 p = dice.RollVector(-4, 4), d = dice.RollVector(-4, 4), q = dice.RollVector(-4, 4),
                e = dice.RollVector(-4, 4);
  const Rational s(dice.Roll(0, 12), 12), offset(dice.Roll(-9, 9), 4), weight = Weight(path).At(s);
  const Pose X = path.At(s);
  RC_ASSERT(X * Backwards(path).At(s) == Pose{});
  RC_ASSERT(HeightAlong(path, p, e, offset).At(s) == weight * (Dot(e, X * p) - offset));
  // The reciprocal product is six times the volume of the tetrahedron of p, p + d, q, q + e.
  const Vector3 at = X * p, along = X.rotation * d;
  RC_ASSERT(MeetingAlong(path, p, d, q, e).At(s) == weight * Dot(at - q, Cross(along, e)));
  const BoundingBox box = SweptBox(path, p);
  RC_ASSERT(box.Overlaps(BoxOf(at)));
}

// Twin: convex parts against parts, decided by cones at 41 places along the path.
void ExpectSamplesAgree(const SampleBody& moving, const SampleBody& fixed, const MotionPath& path,
                        std::map<std::string, int>& seen) {
  const PathContacts found = FollowPath(moving.solid, fixed.solid, path);
  if (found.event) {
    const QuadraticRoot& s = found.event->parameter;
    ++seen[s.is_rational() ? "event" : "irrational event"];
    if (s.is_rational() && moving.parts.size() == 1 && fixed.parts.size() == 1) {
      ++seen["event of convex solids"];
      ASSERT_NE(MeetingOf(Transform(moving, path.At(s.center)), fixed), Meeting::kApart) << found.event->what;
    }
    return;
  }
  const bool touches = !found.start.relation.contacts.empty();
  ++seen[touches ? "touching" : "apart"];
  constexpr int kSteps = 40;
  for (int i = 0; i <= kSteps; ++i) {
    const Meeting meeting = MeetingOf(Transform(moving, path.At(Rational(i, kSteps))), fixed);
    ASSERT_NE(meeting, Meeting::kOverlapping) << i;
    if (i < kSteps) {
      ASSERT_EQ(meeting == Meeting::kTouching, touches) << i;
    }
  }
}

TEST(FollowPath, NoEventMeansNoneOfManySamplesOverlapsOrTouchesOtherwiseAndConvexSolidsMeetAtAnEvent) {
  std::map<std::string, int> seen;
  for (unsigned seed = 0; seed < 60; ++seed) {
    Dice dice(seed);
    const SampleBody fixed = RandomBody(dice);
    const SampleBody moving = RandomlyPlaced(dice, RandomBody(dice), fixed);
    ExpectSamplesAgree(moving, fixed, AnyPath(dice), seen);
    ExpectSamplesAgree(Transform(moving, Pose{{}, dice.RollVector(-3, 3)}), fixed, AnyPath(dice), seen);
    if (HasFatalFailure()) FAIL() << "seed " << seed;
  }
  for (const char* kind : {"event", "event of convex solids", "irrational event", "apart"})
    EXPECT_GT(seen[kind], 0) << kind;
}

TEST(FollowPath, SlidingContactsAreKeptWithoutEvents) {
  int kept = 0;
  for (unsigned seed = 0; seed < 40; ++seed) {
    Dice dice(seed);
    const SampleBody table = Convex(Box({-20, -20, -1}, {20, 20, 0}));
    const SampleBody body = RandomBody(dice);
    Rational low = body.solid.vertices[0].point.z;
    for (const Vertex& v : body.solid.vertices) low = std::min(low, v.point.z);
    const SampleBody on = Transform(body, Pose{{}, {dice.Roll(-2, 2), dice.Roll(-2, 2), -low}});
    const Rational size(dice.Roll(1, 3), 2);
    const MotionPath slide =
        seed % 2 == 0 ? MotionPath::Line({size, 1, 0}) : MotionPath::Rotation({0, 1, 0}, {0, 0, size});
    const PathContacts found = FollowPath(on.solid, table.solid, slide);
    ASSERT_EQ(Why(found), "") << seed;
    ASSERT_FALSE(found.start.relation.contacts.empty());
    ASSERT_EQ(BriefOf(found.start.relation), BriefOf(found.end.relation));
    ++kept;
  }
  EXPECT_EQ(kept, 40);
}

}  // namespace
}  // namespace tact::algebra
