// The contact relation against what really happens when the solid is moved a little, exactly.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

struct Twist {
  Vector3 w, v;
};

enum class Prediction { kFree, kBlocked, kUndecided };

// Free: every contact has a plane that its point leaves. Blocked: some contact's point goes behind all planes.
Prediction Predict(const ContactRelation& relation, const Twist& V) {
  bool free = true;
  for (const Contact& contact : relation.contacts) {
    const Vector3 velocity = V.v + Cross(V.w, contact.point);
    int best = -1;
    for (const Vector3& n : contact.planes) best = std::max(best, Dot(n, velocity).sign());
    if (best < 0) return Prediction::kBlocked;
    free = free && best > 0;
  }
  return free ? Prediction::kFree : Prediction::kUndecided;
}

// About the origin by twice the angle whose tangent is |w| step / 2, then by step v.
Pose SmallMotion(const Twist& V) {
  const Rational step(Integer(1), Integer(1L << 40));
  const Vector3 half = (step / 2) * V.w;
  return {Rotation::FromQuaternion(1, half.x, half.y, half.z), step * V.v};
}

// A parallel edge-edge contact's end points with their unions of planes allow rotations that the edge between
// them does not (the ledger, thesis.2.1.singular-edges).
bool CornersSuffice(const ContactRelation& relation, const Twist& V) {
  return V.w.IsZero() || !relation.singular() || relation.contacts.size() == 1;
}

struct Tally {
  int touching = 0, overlapping = 0, free = 0, blocked = 0, singular = 0;
  std::map<std::string, int> kinds;
};

void TryPair(Dice& dice, const SampleBody& moving, const SampleBody& fixed, Tally& tally) {
  const FoundContacts found = FindContacts(moving.solid, fixed.solid, 0);
  const Meeting meeting = MeetingOf(moving, fixed);
  ASSERT_EQ(found.penetration.has_value(), meeting == Meeting::kOverlapping);
  ASSERT_EQ(!found.relation.contacts.empty(), meeting == Meeting::kTouching);
  tally.overlapping += meeting == Meeting::kOverlapping ? 1 : 0;
  if (meeting != Meeting::kTouching) return;
  ++tally.touching;
  tally.singular += found.relation.singular() ? 1 : 0;
  for (const ContactPrimitive& primitive : found.primitives) ++tally.kinds[KindOf(primitive)];
  std::vector<std::pair<const Polyhedron*, const Polyhedron*>> close;  // no others meet after a small motion
  for (const Polyhedron& p : moving.parts) {
    for (const Polyhedron& q : fixed.parts) {
      if (MeetingOf(p, q) == Meeting::kTouching) close.emplace_back(&p, &q);
    }
  }
  for (int i = 0; i < 12; ++i) {
    Twist V{dice.RollVector(-3, 3), dice.RollVector(-3, 3)};
    if (i % 2 == 0) V.w = {};
    const Prediction prediction = Predict(found.relation, V);
    if (prediction == Prediction::kUndecided) continue;
    if (prediction == Prediction::kFree && !CornersSuffice(found.relation, V)) continue;
    const Pose X = SmallMotion(V);
    const bool meets = std::any_of(close.begin(), close.end(), [&](const auto& pair) {
      return MeetingOf(Transform(*pair.first, X), *pair.second) == Meeting::kOverlapping;
    });
    ASSERT_EQ(meets, prediction == Prediction::kBlocked)
        << "w " << ToString(V.w) << " v " << ToString(V.v) << " " << BriefOf(found.relation);
    ++(meets ? tally.blocked : tally.free);
  }
}

TEST(FirstOrderTwin, SmallMotionsOverlapAsTheRelationSays) {
  Tally tally;
  for (unsigned seed = 0; seed < 700; ++seed) {
    Dice dice(seed);
    const SampleBody fixed = RandomBody(dice);
    const SampleBody moving = RandomlyPlaced(dice, RandomBody(dice), fixed);
    SCOPED_TRACE("seed " + std::to_string(seed));
    TryPair(dice, moving, fixed, tally);
    if (HasFatalFailure()) return;
  }
  // Every kind took part, and often.
  EXPECT_GT(tally.touching, 400);
  EXPECT_GT(tally.overlapping, 60);
  EXPECT_GT(tally.free, 1000);
  EXPECT_GT(tally.blocked, 1000);
  EXPECT_GT(tally.singular, 100);
  EXPECT_EQ(tally.kinds.size(), 9u);
  for (const auto& [kind, count] : tally.kinds) EXPECT_GT(count, 15) << kind;
}

// Six of eight cubes around a point, two opposite ones missing: the solid's surface is pinched there, with two
// vertices, and what one vertex alone looks like fills the other's void.
TEST(FirstOrderTwin, ABoxInOneVoidOfAPinchTouchesThreeFaces) {
  Cubes cubes;
  for (int i = 1; i < 7; ++i) cubes.cells.push_back({i & 1, i >> 1 & 1, i >> 2});
  const SampleBody fixed{BuildPolyhedron(cubes.OneShell()), cubes.Parts()};
  ASSERT_EQ(ElementsAt(fixed.solid, {1, 1, 1}).size(), 2u);
  const SampleBody moving = Convex(Box({0, 0, 0}, {1, 1, 1}));
  const FoundContacts found = FindContacts(moving.solid, fixed.solid, 0);
  EXPECT_FALSE(found.penetration);
  EXPECT_EQ(MeetingOf(moving, fixed), Meeting::kTouching);
  // Three faces of the void hold it from above.
  EXPECT_EQ(BriefOf(found.relation), "030/030/33");
}

}  // namespace
}  // namespace tact::algebra
