#include "enumerators/contact_additions.h"

#include <gtest/gtest.h>

#include <map>

namespace tact::enumerators {
namespace {

using algebra::Contact;
using algebra::Vector3;

// Contacts on the plane z = 0, pressed upwards.
ContactWorld Table(const std::vector<std::pair<int, int>>& points) {
  ContactWorld world{"a table", {}, 1};
  for (const auto& [x, y] : points) world.contacts.push_back({{x, y, 0}, {{0, 0, 1}}, ""});
  return world;
}

std::map<std::pair<AdditionKind, size_t>, int> Sizes(const ContactWorld& world) {
  std::map<std::pair<AdditionKind, size_t>, int> sizes;
  for (const Addition& addition : Additions(world)) ++sizes[{addition.kind, addition.contacts.size()}];
  return sizes;
}

using enum AdditionKind;

// By hand: a square has six edges and diagonals, four triangles, and itself.
TEST(Additions, OfASquare) {
  EXPECT_EQ(Sizes(Table({{0, 0}, {1, 0}, {1, 1}, {0, 1}})),
            (decltype(Sizes({})){{{kContact, 1}, 4}, {{kEdge, 2}, 6}, {{kFace, 3}, 4}, {{kFace, 4}, 1}}));
}

// The centre is on both diagonals: two of ten triples are on a line, and no quadrangle has it for a corner.
TEST(Additions, OfASquareWithItsCentre) {
  EXPECT_EQ(Sizes(Table({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}})),
            (decltype(Sizes({})){{{kContact, 1}, 5}, {{kEdge, 2}, 10}, {{kFace, 3}, 8}, {{kFace, 4}, 1}}));
}

TEST(Additions, ATriangleWithAPointInsideIsNoQuadrangle) {
  for (const auto& points : {std::vector<std::pair<int, int>>{{0, 0}, {3, 0}, {0, 3}, {1, 1}},
                             std::vector<std::pair<int, int>>{{1, 1}, {0, 0}, {3, 0}, {0, 3}},
                             std::vector<std::pair<int, int>>{{0, 3}, {3, 0}, {1, 1}, {0, 0}}}) {
    EXPECT_EQ(Sizes(Table(points)),
              (decltype(Sizes({})){{{kContact, 1}, 4}, {{kEdge, 2}, 6}, {{kFace, 3}, 4}}));
  }
}

TEST(Additions, TakeOneNormalWhateverItsLengthAndNotItsReverse) {
  ContactWorld world = Table({{0, 0}, {1, 0}});
  world.contacts[1].planes[0] = {0, 0, 2};
  EXPECT_EQ(Additions(world).size(), 3U);
  world.contacts[1].planes[0] = {0, 0, -1};
  EXPECT_EQ(Additions(world).size(), 2U);
  world.contacts[1].planes[0] = {0, 1, 1};
  EXPECT_EQ(Additions(world).size(), 2U);
}

// Lines of action count, not points: these three lie on a line, but their lines of action do not lie in a plane.
TEST(Additions, LookAlongTheNormal) {
  ContactWorld world{"", {}, 1};
  for (const Vector3& p : {Vector3{0, 0, 0}, Vector3{1, 0, 5}, Vector3{0, 1, -7}})
    world.contacts.push_back({p, {{0, 0, 1}}, ""});
  EXPECT_EQ(Sizes(world)[std::pair(kFace, 3)], 1);
  world.contacts[2].point = {2, 0, 9};
  EXPECT_EQ(Sizes(world)[std::pair(kFace, 3)], 0);
}

// 24 contacts, four with each of six normals, at a square's corners.
TEST(Additions, OfACube) {
  EXPECT_EQ(Sizes(CubeWorld(1)),
            (decltype(Sizes({})){{{kContact, 1}, 24}, {{kEdge, 2}, 36}, {{kFace, 3}, 24}, {{kFace, 4}, 6}}));
}

}  // namespace
}  // namespace tact::enumerators
