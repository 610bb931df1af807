#include "enumerators/contact_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tact::enumerators {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Vector3;

// A relation as the places of its contacts in the world; each contact is found there just once.
std::vector<size_t> Places(const ContactWorld& world, const ContactRelation& relation) {
  std::vector<size_t> places;
  for (const Contact& contact : relation.contacts) {
    const auto found = std::find(world.contacts.begin(), world.contacts.end(), contact);
    EXPECT_NE(found, world.contacts.end());
    places.push_back(static_cast<size_t>(found - world.contacts.begin()));
  }
  return places;
}

std::vector<std::vector<size_t>> Walk(const ContactWorld& world) {
  std::vector<std::vector<size_t>> relations;
  ForEachRelation(world,
                  [&](const ContactRelation& relation) { relations.push_back(Places(world, relation)); });
  return relations;
}

// Brute: every sequence of every length, sorted, kept once.
std::set<std::vector<size_t>> Multisets(size_t contacts, size_t largest) {
  std::set<std::vector<size_t>> all = {{}}, last = all;
  for (size_t size = 1; size <= largest; ++size) {
    std::set<std::vector<size_t>> next;
    for (const auto& shorter : last) {
      for (size_t i = 0; i < contacts; ++i) {
        std::vector<size_t> longer = shorter;
        longer.push_back(i);
        std::sort(longer.begin(), longer.end());
        next.insert(longer);
      }
    }
    all.insert(next.begin(), next.end());
    last = std::move(next);
  }
  return all;
}

std::vector<ContactWorld> SmallWorlds() {
  ContactWorld three = AxisWorld(4), none = AxisWorld(3);
  three.contacts.resize(3);
  none.contacts.clear();
  return {AxisWorld(0), AxisWorld(1), AxisWorld(2), SingularWorld(2), DiagonalWorld(1), three, none};
}

TEST(ContactWorld, EveryMultisetIsVisitedOnceAndCounted) {
  for (const ContactWorld& world : SmallWorlds()) {
    const auto walked = Walk(world);
    const std::set<std::vector<size_t>> different(walked.begin(), walked.end());
    EXPECT_EQ(different.size(), walked.size()) << world.sentence;
    EXPECT_EQ(different, Multisets(world.contacts.size(), world.largest)) << world.sentence;
    EXPECT_EQ(Count(world), walked.size()) << world.sentence;
  }
}

TEST(ContactWorld, ShorterRelationsComeFirstThenLexicographicOrder) {
  for (const ContactWorld& world : SmallWorlds()) {
    const auto walked = Walk(world);
    for (size_t i = 0; i < walked.size(); ++i) {
      EXPECT_TRUE(std::is_sorted(walked[i].begin(), walked[i].end()));
      if (i == 0) continue;
      const auto &a = walked[i - 1], &b = walked[i];
      ASSERT_TRUE(a.size() < b.size() || (a.size() == b.size() && a < b)) << world.sentence << ", " << i;
    }
  }
}

// 9 of 27 grid points start a line along an axis, 15 one along a face diagonal, 19 one along a space diagonal:
// those whose predecessor is off the grid. There are 6, 12 and 8 such normals.
TEST(ContactWorld, TheNumbersOfContactsAreThoseCountedByHand) {
  EXPECT_EQ(AxisWorld(1).contacts.size(), 6u * 9);
  EXPECT_EQ(DiagonalWorld(1).contacts.size(), 6u * 9 + 12 * 15 + 8 * 19);
  // Of 0, x, y, z two are on one line along an axis; and 12 of the 15 pairs of normals are square at each point.
  EXPECT_EQ(SingularWorld(1).contacts.size(), 6u * 3 + 4 * 12);
  EXPECT_EQ(Count(AxisWorld(4)), 424270u);  // binomial(58, 4)
}

bool SameLineOfAction(const Contact& a, const Contact& b) {
  return a.planes == b.planes && Parallel(a.point - b.point, a.planes[0]);
}

TEST(ContactWorld, ContactsOnOneLineOfActionAreOneAndNoneIsLeftOut) {
  const ContactWorld world = DiagonalWorld(1);
  for (size_t i = 0; i < world.contacts.size(); ++i) {
    for (size_t j = 0; j < i; ++j) ASSERT_FALSE(SameLineOfAction(world.contacts[i], world.contacts[j]));
  }
  for (int code = 0; code < 729; ++code) {
    const auto digit = [&](int place) { return algebra::Rational(code / place % 3 - 1); };
    const Contact contact{{digit(1), digit(3), digit(9)}, {{digit(27), digit(81), digit(243)}}, ""};
    if (contact.planes[0].IsZero()) continue;
    EXPECT_EQ(std::count_if(world.contacts.begin(), world.contacts.end(),
                            [&](const Contact& other) { return SameLineOfAction(contact, other); }),
              1);
  }
}

}  // namespace
}  // namespace tact::enumerators
