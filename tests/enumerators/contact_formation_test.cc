#include "enumerators/contact_formation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "algebra/contact/dof_transition.h"
#include "enumerators/lattice_solid.h"
#include "enumerators/solid_family.h"

namespace tact::enumerators {
namespace {

using algebra::MotionDof;
using algebra::Polyhedron;
using algebra::Rational;
using algebra::Vector3;

Polyhedron Box(int x, int y, int z) { return LatticeSolid({{{0, 0, 0}, {x, y, z}}}); }
Polyhedron Slot() { return LatticeSolid({{{0, 0, 0}, {3, 1, 2}}}, {{{1, 0, 1}, {2, 1, 2}}}); }

std::map<int, size_t> CountByDimension(const FormationComplex& complex) {
  std::map<int, size_t> count;
  for (const Formation& f : complex.formations) ++count[f.dimension];
  return count;
}

// By hand. Along each axis the cube's interval touches the block's on either side (2 places), sticks out of it (2 open ranges),
// is flush with an end (2 places) or strictly inside (1 open range): 7 states, 5 of them not touching. In contact at least
// one axis touches: 7^3 - 5^3 = 218 formations, and one more is free.
TEST(ContactFormation, CubeOnABlockCountedByHand) {
  const FormationComplex complex = FindFormations(Box(1, 1, 1), Box(2, 2, 2));
  EXPECT_EQ(complex.formations.size(), 219U);
  // Of dimension 0: all three axes at one of 4 places, not all of them flush: 4^3 - 2^3. Of dimension 2: one axis touches,
  // the others are in one of 3 open ranges: 3 * 2 * 9. The rest of 218 has dimension 1.
  EXPECT_EQ(CountByDimension(complex), (std::map<int, size_t>{{0, 56}, {1, 108}, {2, 54}, {3, 1}}));
  // Borders: pairs of states of an axis with the second in the closure of the first: 13 of 7 states, 11 of them from a state
  // that does not touch. 13^3 - 11^3 of the pairs begin with a touching state, 218 are a formation with itself, and the
  // free formation borders on all.
  EXPECT_EQ(complex.borders.size(), 13U * 13 * 13 - 11 * 11 * 11 - 218 + 218);
}

// A flush cube has the translational DOFs of a plane contact: two maintaining, one detaching.
TEST(ContactFormation, CubeInsideABlocksFace) {
  size_t inside = 0;
  for (const Formation& f : FindFormations(Box(1, 1, 1), Box(3, 3, 1)).formations) {
    if (f.pose != Vector3{1, 1, 1}) continue;
    ++inside;
  }
  EXPECT_EQ(inside, 0U);  // (1, 1, 1) is no corner of anything: its formation is the open range around it
  for (const Formation& f : FindFormations(Box(1, 1, 1), Box(2, 2, 1)).formations) {
    if (f.pose != Vector3{Rational(1, 2), Rational(1, 2), 1}) continue;
    ++inside;
    EXPECT_FALSE(f.dof.singular);
    EXPECT_EQ(f.dof.translation, (algebra::TranslationDof{2, 1, 0, 1}));
    EXPECT_EQ(f.dimension, 2);
    EXPECT_EQ(f.relation.contacts.size(), 4U);
  }
  EXPECT_EQ(inside, 1U);
}

// The thesis' F and G (2.8.2): both bottom edges of the peg on both rims, then inside with both walls flush.
TEST(ContactFormation, PegEntersASlotOfItsWidth) {
  const FormationComplex complex = FindFormations(Box(1, 1, 2), Slot());
  const auto at = [&](const Vector3& pose) -> size_t {
    for (size_t i = 0; i < complex.formations.size(); ++i) {
      if (complex.formations[i].pose == pose) return i;
    }
    ADD_FAILURE() << "no formation at " << ToString(pose);
    return 0;
  };
  // With both ends flush as well: y = 0.
  const size_t rims = at({1, 0, 2}), inside = at({1, 0, Rational(3, 2)});
  EXPECT_TRUE(complex.formations[rims].dof.singular);
  EXPECT_EQ(complex.formations[rims].dof.translation.maintaining, 3);
  EXPECT_FALSE(complex.formations[inside].dof.singular);
  EXPECT_EQ(complex.formations[inside].dof.translation, (algebra::TranslationDof{2, 0, 1, 1}));
  EXPECT_EQ(std::count_if(complex.borders.begin(), complex.borders.end(),
                          [&](const Border& b) { return b.open == inside && b.border == rims; }),
            1);
}

TEST(ContactFormation, BordersLoseDimensionsAndKeepPairsTouching) {
  const FormationComplex complex = FindFormations(Box(1, 1, 1), Slot());
  std::set<std::pair<size_t, size_t>> seen;
  for (const Border& border : complex.borders) {
    EXPECT_GT(complex.formations[border.open].dimension, complex.formations[border.border].dimension);
    EXPECT_TRUE(seen.emplace(border.open, border.border).second);
    EXPECT_EQ(seen.count({border.border, border.open}), 0U);
    const auto place = [&](const Rational& s) {
      const Vector3 pose = border.border_pose + s * (border.open_pose - border.border_pose);
      return PairsOf(FindContacts(Transform(Box(1, 1, 1), {{}, pose}), Slot(), 0));
    };
    EXPECT_EQ(place(1), complex.formations[border.open].pairs);
    EXPECT_EQ(place({1, 50}), complex.formations[border.open].pairs);
    EXPECT_EQ(place(0), complex.formations[border.border].pairs);
  }
}

// Twin, brute force: at all quarter coordinates the pairs that touch are those of some formation, and no formation is missed.
void ExpectQuartersShowTheFormations(const Polyhedron& moving, const Polyhedron& fixed, int steps) {
  const FormationComplex complex = FindFormations(moving, fixed);
  std::set<ElementPairs> known, seen;
  for (const Formation& f : complex.formations) known.insert(f.pairs);
  for (int x = -4 * 4; x <= 4 * 4; ++x) {
    for (int y = -steps * 4; y <= steps * 4; ++y) {
      for (int z = -steps * 4; z <= steps * 4; ++z) {
        const Vector3 pose = {Rational(x, 4), Rational(y, 4), Rational(z, 4)};
        const auto found = FindContacts(Transform(moving, {{}, pose}), fixed, 0);
        if (!found.penetration) seen.insert(PairsOf(found));
      }
    }
  }
  EXPECT_EQ(seen, known);
}

TEST(ContactFormation, QuarterCoordinatesShowNoOtherInASlot) {
  ExpectQuartersShowTheFormations(Box(1, 1, 2), Slot(), 2);
}

TEST(ContactFormation, QuarterCoordinatesShowNoOtherOfACornerCutOff) {
  ExpectQuartersShowTheFormations(CornerHulls()[1], Box(2, 1, 1), 2);
}

// A regular tetrahedron between the walls of a slot: opposite edges' ends push on it from both sides. Where the lines between
// them cross depends on how far it is in, so the same elements touch with other DOFs in rotation. Worked out by hand: at
// y = -1/4 the segments from (3/4, 2) to (0, 5/4) and from (3/4, 1) to (0, 7/4) cross, at -3/4 they do not meet.
TEST(ContactFormation, SameElementsMayTouchWithOtherDofs) {
  const Polyhedron tetrahedron = CornerHulls()[3];
  ASSERT_EQ(tetrahedron.vertices.size(), 4U);
  const auto at = [&](const Rational& y) {
    return FindContacts(Transform(tetrahedron, {{}, {1, y, 1}}), Slot(), 0);
  };
  const auto near = at({-1, 4}), far = at({-3, 4});
  EXPECT_EQ(PairsOf(near), PairsOf(far));
  EXPECT_EQ(ComputeMotionDof(near.relation).rotation.constraining, 2);
  EXPECT_EQ(ComputeMotionDof(far.relation).rotation.constraining, 0);
  const FormationComplex complex = FindFormations(tetrahedron, Slot());
  EXPECT_TRUE(std::any_of(complex.formations.begin(), complex.formations.end(),
                          [&](const Formation& f) { return f.pairs == PairsOf(near) && f.uneven; }));
}

TEST(ContactFormation, BoxesAreEven) {
  for (const Formation& f : FindFormations(Box(1, 1, 2), Slot()).formations) EXPECT_FALSE(f.uneven);
}

}  // namespace
}  // namespace tact::enumerators
