#include "algebra/contact/approach.h"

#include <gtest/gtest.h>

namespace tact::algebra {
namespace {

Polyhedron Box(const Vector3& a, const Vector3& b) {
  PolygonSoup soup;
  for (int i = 0; i < 8; ++i)
    soup.points.push_back({(i & 1) != 0 ? b.x : a.x, (i & 2) != 0 ? b.y : a.y, (i & 4) != 0 ? b.z : a.z});
  soup.polygons = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return BuildPolyhedron(soup);
}

Approach Approaching(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path) {
  return ApproachEnd(moving, fixed, path, FindContacts(Transform(moving, path.At(1)), fixed, 0));
}

DofPairing Pairing(const Approach& approach, const Polyhedron& moving, const Polyhedron& fixed,
                   Motion motion) {
  const auto& directions = approach.directions[motion == Motion::kTranslation ? 0 : 1];
  return PairByDirection(directions, FilterDirections(FindContacts(moving, fixed, 0).relation, motion));
}

const Polyhedron& Table() {
  static const Polyhedron table = Box({-4, -4, -1}, {4, 4, 0});
  return table;
}

// A box tilted about its bottom edge x = 1 is laid down on a table: translation stays as it is, and of the rotations the one
// that lays it down is stopped. By hand: about the edge, maintaining becomes detaching of one kind; the table's normal z stays
// maintaining, x stays detaching.
TEST(Approach, BoxLaidDownOnATable) {
  const Polyhedron box = Box({-1, -1, 0}, {1, 1, 1});
  const Approach approach = Approaching(box, Table(), MotionPath::Rotation({1, 0, 0}, {0, {1, 2}, 0}));
  EXPECT_EQ(approach.relation.contacts.size(), 2U);
  const auto translation = Pairing(approach, box, Table(), Motion::kTranslation);
  EXPECT_EQ(translation[0][0], 2);
  EXPECT_EQ(translation[1][1], 1);
  const auto rotation = Pairing(approach, box, Table(), Motion::kRotation);
  EXPECT_EQ(rotation[0][0], 1);
  EXPECT_EQ(rotation[0][1], 1);
  EXPECT_EQ(rotation[1][1], 1);
}

// The same with the table's edge under the box's face: the contacts' normal turns with the box, and only its limit can be
// compared. Taken where the box is tilted, horizontal directions seem to turn from maintaining to detaching and back.
TEST(Approach, FaceLaidDownOnAnEdgeIsComparedInTheLimit) {
  const Polyhedron box = Box({-5, -1, 0}, {5, 1, 1});
  const MotionPath path = MotionPath::Rotation({4, 0, 0}, {0, {1, 2}, 0});
  const auto contacts = FindContacts(Transform(box, path.At(1)), Table(), 0);
  ASSERT_FALSE(contacts.penetration);
  ASSERT_EQ(contacts.relation.contacts.size(), 2U);
  ASSERT_NE(contacts.relation.contacts[0].planes[0].x.sign(), 0);
  const auto tilted =
      PairByDirection(contacts.relation, FindContacts(box, Table(), 0).relation, Motion::kTranslation);
  EXPECT_EQ(tilted[0][1], 1);
  EXPECT_EQ(tilted[1][0], 1);
  const auto limit = Pairing(ApproachEnd(box, Table(), path, contacts), box, Table(), Motion::kTranslation);
  EXPECT_EQ(limit[0][0], 2);
  EXPECT_EQ(limit[1][1], 1);
}

// An upright prism over a polygon, counter-clockwise seen from above.
Polyhedron Prism(const std::vector<std::pair<int, int>>& polygon, int bottom, int top) {
  PolygonSoup soup;
  const size_t n = polygon.size();
  for (const int z : {bottom, top}) {
    for (const auto& [x, y] : polygon) soup.points.push_back({x, y, z});
  }
  std::vector<size_t> below, above;
  for (size_t i = 0; i < n; ++i) {
    below.insert(below.begin(), i);
    above.push_back(n + i);
    soup.polygons.push_back({i, (i + 1) % n, n + (i + 1) % n, n + i});
  }
  soup.polygons.push_back(below);
  soup.polygons.push_back(above);
  return BuildPolyhedron(soup);
}

// Two plates hinge about the line x = z = 0: for y > 0 an edge of the upper one lies on the lower one's face, for y < 0
// an edge of the lower one on the upper one's face. The two normals become parallel when the plates lie flat: tilted, only y
// is maintaining; flat, x is too. So by hand x goes from detaching to maintaining, which the rows at s = 0 would not show.
TEST(Approach, RankIsNotLostWhenNormalsBecomeParallel) {
  const Polyhedron lower = Prism({{-4, -4}, {0, -4}, {0, 0}, {4, 0}, {4, 4}, {-4, 4}}, -1, 0);
  const Polyhedron upper =
      Prism({{-3, -3}, {3, -3}, {3, -1}, {-1, -1}, {-1, 1}, {0, 1}, {0, 3}, {-3, 3}}, 0, 1);
  // About y by a positive angle z turns to x, and x to -z: the part with x < 0 is lifted.
  const MotionPath path = MotionPath::Rotation({0, 0, 0}, {0, {1, 8}, 0});
  const auto contacts = FindContacts(Transform(upper, path.At(1)), lower, 0);
  ASSERT_FALSE(contacts.penetration);
  EXPECT_EQ(ComputeMotionDof(contacts.relation).translation, (TranslationDof{1, 2, 0, 2}));
  const Approach approach = ApproachEnd(upper, lower, path, contacts);
  const auto translation = Pairing(approach, upper, lower, Motion::kTranslation);
  EXPECT_EQ(translation[0][0], 1);
  EXPECT_EQ(translation[1][0], 1);
  EXPECT_EQ(translation[1][1], 1);
}

// Along a line normals stay, and the relation near the end has the planes of the one at the start.
TEST(Approach, NearTheEndOfALine) {
  const Polyhedron box = Box({3, -1, 0}, {5, 1, 1});
  const Polyhedron wall = Box({-4, -4, -1}, {4, 4, 0});
  const MotionPath path = MotionPath::Line({{1, 2}, 0, 0});
  const auto contacts = FindContacts(Transform(box, path.At(1)), wall, 0);
  const Approach approach = ApproachEnd(box, wall, path, contacts);
  ASSERT_EQ(approach.relation.contacts.size(), contacts.relation.contacts.size());
  for (size_t i = 0; i < contacts.relation.contacts.size(); ++i) {
    EXPECT_EQ(approach.relation.contacts[i].planes, contacts.relation.contacts[i].planes);
    EXPECT_LT(Abs(approach.relation.contacts[i].point.x - contacts.relation.contacts[i].point.x),
              Rational(1, 1));
  }
  EXPECT_EQ(ComputeMotionDof(approach.relation), ComputeMotionDof(contacts.relation));
}

}  // namespace
}  // namespace tact::algebra
