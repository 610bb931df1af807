#include "enumerators/turned_contact.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "enumerators/lattice_solid.h"

namespace tact::enumerators {
namespace {

using algebra::Polyhedron;
using algebra::Rational;
using algebra::Vector3;

Polyhedron Box(int x, int y, int z) { return LatticeSolid({{{0, 0, 0}, {x, y, z}}}); }

struct Turned {
  Polyhedron moving = Box(1, 1, 1), fixed = Box(1, 1, 1);
  FormationComplex complex = FindFormations(moving, fixed);
  TurnedContacts contacts = FindTurnedContacts(moving, fixed, complex);
};

const Turned& CubeOnCube() {
  static const Turned turned;
  return turned;
}

TEST(TurnedContact, EachIsAPathThatKeepsItsContacts) {
  const Turned& t = CubeOnCube();
  ASSERT_FALSE(t.contacts.found.empty());
  EXPECT_EQ(t.contacts.undecided, 0U);
  for (size_t i = 0; i < t.contacts.found.size(); i += 37) {
    const TurnedContact& contact = t.contacts.found[i];
    const Formation& border = t.complex.formations[contact.border];
    const algebra::MotionPath path = PathOf(contact.turn);
    for (const Rational& s : {Rational(1), Rational(1, 2), Rational(1, 30)}) {
      const auto found =
          FindContacts(Transform(t.moving, path.At(s) * algebra::Pose{{}, border.pose}), t.fixed, 0);
      EXPECT_FALSE(found.penetration);
      EXPECT_EQ(PairsOf(found), PairsOf(contact.contacts));
    }
    EXPECT_NE(PairsOf(contact.contacts), border.pairs);
    EXPECT_EQ(TurnedPose(border.pose, contact.turn), path.At(1) * (algebra::Pose{{}, border.pose}));
  }
}

// By hand: a cube that lies flush on a face of an equal one tilts about any of the four edges of that face to an
// edge-face contact, on the moving cube's edge or the fixed one's as both are the same there: four ways; and it cannot
// turn into the other cube.
TEST(TurnedContact, CubeOnAnEqualCubeTiltsAboutFourEdges) {
  const Turned& t = CubeOnCube();
  const auto on_top =
      std::find_if(t.complex.formations.begin(), t.complex.formations.end(), [](const Formation& f) {
        return f.pose == Vector3{0, 0, 1};
      });
  ASSERT_NE(on_top, t.complex.formations.end());
  const auto index = static_cast<size_t>(on_top - t.complex.formations.begin());
  std::vector<Turn> turns;
  for (const TurnedContact& contact : t.contacts.found) {
    if (contact.border == index && contact.turn.axis != 2) turns.push_back(contact.turn);
  }
  EXPECT_EQ(turns.size(), 4U);
  for (const Turn& turn : turns) EXPECT_EQ(turn.center.z, Rational(1));
}

TEST(TurnedContact, NoTiltOfOneFormationComesTwice) {
  const Turned& t = CubeOnCube();
  std::set<std::pair<size_t, ElementPairs>> seen;
  for (const TurnedContact& contact : t.contacts.found)
    EXPECT_TRUE(seen.emplace(contact.border, PairsOf(contact.contacts)).second);
}

}  // namespace
}  // namespace tact::enumerators
