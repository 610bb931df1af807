#include <gtest/gtest.h>

#include <set>

#include "algebra/error.h"
#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

using Corners = std::multiset<std::pair<Vector3, std::set<Vector3>>>;

// Points with their planes, in no order; sign -1 reverses every plane.
Corners CornersOf(const ContactRelation& relation, int sign) {
  Corners corners;
  for (const Contact& contact : relation.contacts) {
    std::set<Vector3> planes;
    for (const Vector3& n : contact.planes) planes.insert(Rational(sign) * n);
    corners.emplace(contact.point, std::move(planes));
  }
  return corners;
}

// Calls visit(dice, moving, fixed) for random pairs that do not overlap.
template <typename Visit>
int ForEachPair(unsigned first_seed, unsigned seeds, Visit visit) {
  int pairs = 0;
  for (unsigned seed = first_seed; seed < first_seed + seeds; ++seed) {
    Dice dice(seed);
    const SampleBody fixed = RandomBody(dice);
    const SampleBody moving = RandomlyPlaced(dice, RandomBody(dice), fixed);
    if (MeetingOf(moving, fixed) == Meeting::kOverlapping) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    visit(dice, moving.solid, fixed.solid);
    if (testing::Test::HasFailure()) return pairs;
    ++pairs;
  }
  return pairs;
}

TEST(ContactFinderLaw, SwappingTheSolidsReversesEveryNormal) {
  const int pairs = ForEachPair(50000, 150, [](Dice&, const Polyhedron& moving, const Polyhedron& fixed) {
    const ContactRelation relation = FindContacts(moving, fixed, 0).relation;
    const ContactRelation swapped = FindContacts(fixed, moving, 0).relation;
    EXPECT_EQ(CornersOf(relation, 1), CornersOf(swapped, -1));
    EXPECT_EQ(BriefOf(relation), BriefOf(swapped));
  });
  EXPECT_GT(pairs, 100);
}

TEST(ContactFinderLaw, OnePoseForBothSolidsCarriesTheRelation) {
  const int pairs =
      ForEachPair(60000, 150, [](Dice& dice, const Polyhedron& moving, const Polyhedron& fixed) {
        const Pose X{RandomRotation(dice), Rational(1, 3) * dice.RollVector(-9, 9)};
        const FoundContacts here = FindContacts(moving, fixed, 0);
        const FoundContacts there = FindContacts(Transform(moving, X), Transform(fixed, X), 0);
        ContactRelation carried = here.relation;
        for (Contact& contact : carried.contacts) {
          contact.point = X * contact.point;
          for (Vector3& n : contact.planes) n = Primitive(X.rotation * n);
        }
        EXPECT_EQ(CornersOf(there.relation, 1), CornersOf(carried, 1));
        EXPECT_EQ(BriefOf(there.relation), BriefOf(here.relation));
        EXPECT_EQ(there.primitives.size(), here.primitives.size());
        EXPECT_EQ(there.elements, here.elements);
      });
  EXPECT_GT(pairs, 100);
}

// Cubes set on one another, each a shell, are the solid that they make up together.
TEST(ContactFinderLaw, TouchingShellsContactAsTheirUnionDoes) {
  int touching = 0, singular = 0;
  for (unsigned seed = 70000; seed < 70120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const Cubes cubes = RandomCubes(dice);
    const SampleBody fixed{BuildPolyhedron(cubes.OneShell()), cubes.Parts()};
    const SampleBody moving = RandomlyPlaced(dice, RandomBody(dice), fixed);
    const Polyhedron shells = BuildPolyhedron(cubes.ManyShells());
    const FoundContacts one = FindContacts(moving.solid, fixed.solid, 0);
    const FoundContacts many = FindContacts(moving.solid, shells, 0);
    ASSERT_EQ(one.penetration.has_value(), many.penetration.has_value());
    ASSERT_EQ(BriefOf(one.relation), BriefOf(many.relation));
    const FoundContacts reversed = FindContacts(shells, moving.solid, 0);
    ASSERT_EQ(CornersOf(many.relation, 1), CornersOf(reversed.relation, -1));
    touching += one.relation.contacts.empty() ? 0 : 1;
    singular += one.relation.singular() ? 1 : 0;
  }
  EXPECT_GT(touching, 80);
  EXPECT_GT(singular, 15);
}

TEST(ContactFinder, NegativeToleranceIsRefused) {
  const Polyhedron box = BuildPolyhedron(Box({0, 0, 0}, {1, 1, 1}));
  EXPECT_THROW(FindContacts(box, box, Rational(-1, 9)), PreconditionError);
}

}  // namespace
}  // namespace tact::algebra
