#include "algebra/contact/contact_modes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "algebra/error.h"
#include "tests/algebra/cone/fourier_motzkin.h"
#include "tests/algebra/uniform.h"

namespace tact::algebra {
namespace {

using Modes = std::vector<std::string>;

const Vector3 kUp{0, 0, 1};

ContactRelation SquareOnPlane() {
  return {
      {{{1, 1, 0}, {kUp}, ""}, {{1, -1, 0}, {kUp}, ""}, {{-1, -1, 0}, {kUp}, ""}, {{-1, 1, 0}, {kUp}, ""}}};
}

// One contact's rate is zero or positive in the way the definition says, without cones: some plane attains
// the largest rate and all others are at most that.
bool Realised(const ContactRelation& relation, const std::string& mode) {
  std::vector<size_t> selection(relation.contacts.size());
  for (;;) {
    FourierMotzkin system;
    for (size_t i = 0; i < relation.contacts.size(); ++i) {
      const Contact& contact = relation.contacts[i];
      const auto row = [&](const Vector3& n) {
        const Vector3 moment = Cross(contact.point, n);
        return RationalRow{moment.x, moment.y, moment.z, n.x, n.y, n.z};
      };
      const Vector3& largest = contact.planes[selection[i]];
      mode[i] == 'c' ? system.Equal(row(largest)) : system.Positive(row(largest));
      for (const Vector3& other : contact.planes) {
        if (other != largest) system.NonNegative(row(largest - other));
      }
    }
    if (system.Feasible(6)) return true;
    size_t i = 0;
    while (i < selection.size() && ++selection[i] == relation.contacts[i].planes.size()) selection[i++] = 0;
    if (i == selection.size()) return false;
  }
}

Modes BruteModes(const ContactRelation& relation) {
  Modes modes;
  const size_t n = relation.contacts.size();
  for (size_t bits = 0; bits < size_t{1} << n; ++bits) {
    std::string mode(n, 'c');
    for (size_t i = 0; i < n; ++i) {
      if ((bits >> (n - 1 - i) & 1) != 0) mode[i] = 's';
    }
    if (Realised(relation, mode)) modes.push_back(mode);
  }
  return modes;
}

TEST(ContactModes, SquareOnAPlaneHasTheFacesOfAPyramid) {
  // By hand: all kept, four edges (two neighbours kept), four vertices (one kept), none kept.
  const Modes expected = {"cccc", "ccss", "cssc", "csss", "sccs", "scss", "sscc", "sscs", "sssc", "ssss"};
  EXPECT_EQ(ContactModes(SquareOnPlane()), expected);
}

TEST(ContactModes, OpposedContactsAtOnePointAreBothKept) {
  EXPECT_EQ(ContactModes({{{{1, 2, 3}, {kUp}, ""}, {{1, 2, 3}, {-kUp}, ""}}}), Modes{"cc"});
}

TEST(ContactModes, NoContactHasOneMode) { EXPECT_EQ(ContactModes({}), Modes{""}); }

TEST(ContactModes, OneContactIsKeptOrSeparates) {
  EXPECT_EQ(ContactModes({{{{0, 0, 0}, {kUp}, ""}}}), (Modes{"c", "s"}));
}

TEST(ContactModes, SingularContactWithOpposedPlanesMayMoveBothWays) {
  // max(v, -v) = |v|: kept or separating; alone each plane would forbid one way.
  EXPECT_EQ(ContactModes({{{{0, 0, 0}, {kUp, -kUp}, ""}}}), (Modes{"c", "s"}));
}

TEST(ContactModes, SingularContactIsHeldByItsNeighbours) {
  // v_z = 0 by two opposed contacts at the origin; the corner there keeps only where v_x <= 0 and v_z = 0,
  // separates for v_x > 0.
  const ContactRelation corner = {
      {{{0, 0, 0}, {kUp}, ""}, {{0, 0, 0}, {-kUp}, ""}, {{0, 0, 0}, {{1, 0, 0}, kUp}, ""}}};
  EXPECT_EQ(ContactModes(corner), (Modes{"ccc", "ccs"}));
}

TEST(ContactModes, CopiesOfAPlaneAreOnePlane) {
  const ContactRelation copies = {{{{1, 0, 0}, {kUp, Rational(3) * kUp}, ""}, {{0, 1, 0}, {kUp}, ""}}};
  EXPECT_EQ(ContactModes(copies), (Modes{"cc", "cs", "sc", "ss"}));
}

TEST(ContactModes, BudgetIsStatedNotExceeded) {
  EXPECT_EQ(ContactModes(SquareOnPlane(), 10).size(), 10u);
  EXPECT_THROW(ContactModes(SquareOnPlane(), 9), BudgetError);
  ContactRelation singular;
  for (int i = 0; i < 40; ++i) singular.contacts.push_back({{i, 0, 0}, {kUp, {1, 0, 0}}, ""});
  EXPECT_THROW(ContactModes(singular), BudgetError);
}

TEST(ContactModes, BadContactsAreRefusedAndNamed) {
  EXPECT_THROW(ContactModes({{{{0, 0, 0}, {}, ""}}}), PreconditionError);
  try {
    ContactModes({{{{0, 0, 0}, {kUp}, ""}, {{0, 0, 0}, {{0, 0, 0}}, ""}}});
    FAIL() << "a zero normal was taken";
  } catch (const PreconditionError& error) {
    EXPECT_NE(std::string(error.what()).find("contact 2:"), std::string::npos) << error.what();
  }
}

ContactRelation AnyRelation(size_t most_contacts, int most_planes) {
  ContactRelation relation;
  const size_t n = Uniform<size_t>(0, most_contacts + 1);
  while (relation.contacts.size() < n) {
    Contact contact;
    for (int j = 0; j < 3; ++j) contact.point[j] = Rational(Uniform(-1, 2));
    const int planes = Uniform(1, most_planes + 1);
    while (static_cast<int>(contact.planes.size()) < planes) {
      Vector3 normal;
      for (int j = 0; j < 3; ++j) normal[j] = Rational(Uniform(-1, 2));
      if (!normal.IsZero()) contact.planes.push_back(normal);
    }
    relation.contacts.push_back(contact);
  }
  return relation;
}

RC_GTEST_PROP(ContactModesBrute, EveryStringTriedByElimination, ()) {
  const ContactRelation relation = AnyRelation(5, 1);
  RC_ASSERT(ContactModes(relation) == BruteModes(relation));
}

RC_GTEST_PROP(ContactModesBrute, EveryStringTriedByEliminationWithSingularContacts, ()) {
  const ContactRelation relation = AnyRelation(3, 3);
  RC_ASSERT(ContactModes(relation) == BruteModes(relation));
}

RC_GTEST_PROP(ContactModesLaw, ReversingTheContactsReversesTheStrings, ()) {
  const ContactRelation relation = AnyRelation(8, 2);
  ContactRelation reversed = relation;
  std::reverse(reversed.contacts.begin(), reversed.contacts.end());
  Modes modes = ContactModes(reversed);
  for (std::string& mode : modes) std::reverse(mode.begin(), mode.end());
  std::sort(modes.begin(), modes.end());
  RC_ASSERT(modes == ContactModes(relation));
}

}  // namespace
}  // namespace tact::algebra
