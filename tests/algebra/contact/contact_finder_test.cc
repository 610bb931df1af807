// Relations calculated by hand. A brief is translation/rotation/restricted, see BriefOf.
#include "algebra/contact/contact_finder.h"

#include <gtest/gtest.h>

#include <set>

#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

using Planes = std::set<Vector3>;

const Vector3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

std::multiset<std::string> KindsOf(const FoundContacts& found) {
  std::multiset<std::string> kinds;
  for (const ContactPrimitive& primitive : found.primitives) kinds.insert(KindOf(primitive));
  return kinds;
}

Planes PlanesOf(const Contact& contact) { return {contact.planes.begin(), contact.planes.end()}; }

std::set<Vector3> PointsOf(const FoundContacts& found) {
  std::set<Vector3> points;
  for (const Contact& contact : found.relation.contacts) points.insert(contact.point);
  return points;
}

FoundContacts Find(const PolygonSoup& moving, const PolygonSoup& fixed, const Rational& tolerance = 0) {
  return FindContacts(BuildPolyhedron(moving), BuildPolyhedron(fixed), tolerance);
}

// A pyramid with its apex at the origin over (or under) a polygon, counter-clockwise seen from above, at z.
PolygonSoup Pyramid(const std::vector<std::pair<int, int>>& base, int z) {
  PolygonSoup soup{{{0, 0, 0}}, {{}}};
  for (const auto& [x, y] : base) soup.points.push_back({x, y, z});
  const size_t n = base.size();
  for (size_t i = 1; i <= n; ++i) {
    soup.polygons[0].push_back(i);
    soup.polygons.push_back({0, i % n + 1, i});
  }
  return z > 0 ? soup : Reversed(soup);
}

// A prism along x whose ridge, from x = low to high, is the z axis' origin; half as wide as `half` at z.
PolygonSoup Ridge(int half, int z, int low, int high) {
  PolygonSoup soup = z < 0 ? Prism({{0, 0}, {-half, z}, {half, z}}, low, high)
                           : Prism({{0, 0}, {half, z}, {-half, z}}, low, high);
  for (Vector3& p : soup.points) p = {p.z, p.x, p.y};
  return soup;
}

PolygonSoup Table() { return Box({-9, -9, -1}, {9, 9, 0}); }
PolygonSoup Thorn() { return Pyramid({{1, 0}, {-1, 1}, {-1, -1}}, 4); }

TEST(ContactFinder, BoxFlushOnBoxTouchesInTheWholeFace) {
  const FoundContacts found = Find(Box({0, 0, 1}, {2, 3, 2}), Box({0, 0, 0}, {2, 3, 1}));
  EXPECT_EQ(BriefOf(found.relation), "210/120/12");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"face-face"}));
  EXPECT_EQ(PointsOf(found), (std::set<Vector3>{{0, 0, 1}, {2, 0, 1}, {0, 3, 1}, {2, 3, 1}}));
  for (const Contact& contact : found.relation.contacts) EXPECT_EQ(PlanesOf(contact), Planes{kZ});
}

TEST(ContactFinder, BoxOffsetOnBoxTouchesInTheCommonRectangle) {
  const FoundContacts found = Find(Box({1, 1, 1}, {3, 3, 2}), Box({0, 0, 0}, {2, 2, 1}));
  EXPECT_EQ(BriefOf(found.relation), "210/120/12");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"face-face"}));
  EXPECT_EQ(PointsOf(found), (std::set<Vector3>{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, 1}}));
}

// Turned by the angle with cosine 3/5: |x|, |y| <= 2 and |3 x + 4 y|, |4 x - 3 y| <= 10 meet in an octagon.
TEST(ContactFinder, TurnedBoxOnBoxTouchesInAnOctagon) {
  const Pose X{Rotation::FromQuaternion(2, 0, 0, 1), {}};
  const Polyhedron moving = Transform(BuildPolyhedron(Box({-2, -2, 0}, {2, 2, 1})), X);
  const FoundContacts found = FindContacts(moving, BuildPolyhedron(Box({-2, -2, -1}, {2, 2, 0})), 0);
  EXPECT_EQ(BriefOf(found.relation), "210/120/12");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"face-face"}));
  std::set<Vector3> octagon;
  for (const int s : {-1, 1}) {
    octagon.insert({2 * s, 1 * s, 0});
    octagon.insert({2 * s, Rational(-2 * s, 3), 0});
    octagon.insert({1 * s, -2 * s, 0});
    octagon.insert({Rational(2 * s, 3), 2 * s, 0});
  }
  EXPECT_EQ(PointsOf(found), octagon);
}

TEST(ContactFinder, VertexOnFaceAndFaceOnVertex) {
  const FoundContacts down = Find(Thorn(), Table());
  EXPECT_EQ(BriefOf(down.relation), "210/300/10");
  EXPECT_EQ(KindsOf(down), (std::multiset<std::string>{"vertex-face"}));
  ASSERT_EQ(down.relation.contacts.size(), 1u);
  EXPECT_EQ(down.relation.contacts[0].planes, std::vector<Vector3>{kZ});
  const FoundContacts up = Find(Table(), Thorn());
  EXPECT_EQ(BriefOf(up.relation), "210/300/10");
  EXPECT_EQ(KindsOf(up), (std::multiset<std::string>{"face-vertex"}));
  EXPECT_EQ(up.relation.contacts[0].planes, std::vector<Vector3>{-kZ});
}

TEST(ContactFinder, EdgeOnFaceAndFaceOnEdge) {
  const FoundContacts down = Find(Ridge(1, 1, -2, 2), Table());
  EXPECT_EQ(BriefOf(down.relation), "210/210/11");
  EXPECT_EQ(KindsOf(down), (std::multiset<std::string>{"edge-face"}));
  EXPECT_EQ(PointsOf(down), (std::set<Vector3>{{-2, 0, 0}, {2, 0, 0}}));
  EXPECT_EQ(KindsOf(Find(Table(), Ridge(1, 1, -2, 2))), (std::multiset<std::string>{"face-edge"}));
}

TEST(ContactFinder, CrossingEdgesTouchInOnePlane) {
  PolygonSoup across = Ridge(1, 1, -2, 2);
  for (Vector3& p : across.points) p = {-p.y, p.x, p.z};
  const FoundContacts found = Find(across, Ridge(1, -1, -2, 2));
  EXPECT_EQ(BriefOf(found.relation), "210/300/10");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"edge-edge"}));
  EXPECT_EQ(PointsOf(found), (std::set<Vector3>{{0, 0, 0}}));
  EXPECT_EQ(PlanesOf(found.relation.contacts[0]), Planes{kZ});
}

// The sharper edge may leave over either of the blunter one's faces.
TEST(ContactFinder, ParallelEdgesAreSingularWithTheBlunterOnesPlanes) {
  const FoundContacts blunt_below = Find(Ridge(1, 2, -1, 3), Ridge(1, -1, -2, 2));
  EXPECT_EQ(BriefOf(blunt_below.relation), "singular 300/300/22");
  EXPECT_EQ(KindsOf(blunt_below), (std::multiset<std::string>{"edge-edge"}));
  EXPECT_EQ(PointsOf(blunt_below), (std::set<Vector3>{{-1, 0, 0}, {2, 0, 0}}));
  for (const Contact& c : blunt_below.relation.contacts) {
    EXPECT_EQ(PlanesOf(c), (Planes{{0, 1, 1}, {0, -1, 1}}));
  }
  const FoundContacts sharp_below = Find(Ridge(3, 1, -1, 3), Ridge(1, -1, -2, 2));
  for (const Contact& c : sharp_below.relation.contacts) {
    EXPECT_EQ(PlanesOf(c), (Planes{{0, 1, 3}, {0, -1, 3}}));
  }
}

TEST(ContactFinder, VertexOnEdgeAndEdgeOnVertexHaveTheEdgesPlanes) {
  const FoundContacts down = Find(Thorn(), Ridge(1, -1, -2, 2));
  EXPECT_EQ(BriefOf(down.relation), "singular 300/300/20");
  EXPECT_EQ(KindsOf(down), (std::multiset<std::string>{"vertex-edge"}));
  EXPECT_EQ(PlanesOf(down.relation.contacts[0]), (Planes{{0, 1, 1}, {0, -1, 1}}));
  const FoundContacts up = Find(Ridge(1, -1, -2, 2), Thorn());
  EXPECT_EQ(KindsOf(up), (std::multiset<std::string>{"edge-vertex"}));
  EXPECT_EQ(PlanesOf(up.relation.contacts[0]), (Planes{{0, 1, -1}, {0, -1, -1}}));
}

TEST(ContactFinder, SharpVertexOnPyramidHasThePyramidsPlanes) {
  const PolygonSoup below = Pyramid({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, -1);
  const FoundContacts found = Find(Thorn(), below);
  EXPECT_EQ(BriefOf(found.relation), "singular 300/300/30");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"vertex-vertex"}));
  EXPECT_EQ(PlanesOf(found.relation.contacts[0]), (Planes{{1, 0, 1}, {-1, 0, 1}, {0, 1, 1}, {0, -1, 1}}));
}

// At n_z = 1 the lower pyramid allows |n_x| + |n_y| <= 1, the upper |n_x|, |n_y| <= 3/4: an octagon, each corner
// square to an edge of each.
TEST(ContactFinder, PyramidsTipToTipHaveEdgeEdgePlanesOnly) {
  const FoundContacts found =
      Find(Pyramid({{4, 0}, {0, 4}, {-4, 0}, {0, -4}}, 3), Pyramid({{1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, -1));
  Planes octagon;
  for (const int s : {-1, 1}) {
    for (const int t : {-1, 1}) {
      octagon.insert({3 * s, t, 4});
      octagon.insert({s, 3 * t, 4});
    }
  }
  ASSERT_EQ(found.relation.contacts.size(), 1u);
  EXPECT_EQ(PlanesOf(found.relation.contacts[0]), octagon);
}

TEST(ContactFinder, VertexInAConcaveCornerTouchesThreeFacesAtOnePoint) {
  Cubes walls;
  for (int i = 0; i < 7; ++i) walls.cells.push_back({(i & 1) - 1, (i >> 1 & 1) - 1, (i >> 2) - 1});
  PolygonSoup dart{{{0, 0, 0}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}},
                   {{1, 2, 3}, {0, 2, 1}, {0, 3, 2}, {0, 1, 3}}};
  const FoundContacts found = Find(dart, walls.OneShell());
  EXPECT_EQ(BriefOf(found.relation), "030/300/30");
  std::multiset<Planes> planes;
  for (const Contact& contact : found.relation.contacts) planes.insert(PlanesOf(contact));
  EXPECT_EQ(planes, (std::multiset<Planes>{Planes{kX}, Planes{kY}, Planes{kZ}}));
}

// The inner corner of an L's top: the L is two boxes there, and the motion must keep out of both. Above a box
// with faces z and x, what a thorn of slope 5 leaves of the planes between them is z and (5, 0, 1).
TEST(ContactFinder, AMixedVertexGivesAContactForEachConvexPiece) {
  const PolygonSoup ell = Moved(Prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 0, 1), {-1, -1, -1});
  const PolygonSoup thorn = Pyramid({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, 5);
  const FoundContacts on = Find(thorn, ell);
  EXPECT_EQ(BriefOf(on.relation), "singular 300/300/30");
  std::multiset<Planes> planes;
  for (const Contact& contact : on.relation.contacts) planes.insert(PlanesOf(contact));
  EXPECT_EQ(planes, (std::multiset<Planes>{Planes{kZ, {5, 0, 1}}, Planes{kZ, {0, 5, 1}}}));
  planes.clear();
  for (const Contact& contact : Find(ell, thorn).relation.contacts) planes.insert(PlanesOf(contact));
  EXPECT_EQ(planes, (std::multiset<Planes>{Planes{-kZ, {-5, 0, -1}}, Planes{-kZ, {0, -5, -1}}}));
}

TEST(ContactFinder, AHoleAroundAPegLeavesOneTranslation) {
  const FoundContacts found = Find(PlateWithHole(), Box({2, 2, -1}, {4, 4, 3}));
  EXPECT_EQ(BriefOf(found.relation), "102/003/23");
  EXPECT_EQ(KindsOf(found), (std::multiset<std::string>{"face-face", "face-face", "face-face", "face-face"}));
  EXPECT_EQ(found.relation.contacts.size(), 16u);  // two walls at each of eight corners
}

// A peg with a shoulder and a slot without clearance, outlines in x and z, both along y.
PolygonSoup AlongY(const std::vector<std::pair<Rational, Rational>>& outline, int half) {
  PolygonSoup soup = Prism(outline, -half, half);
  for (Vector3& p : soup.points) p = {p.x, -p.z, p.y};
  return soup;
}

TEST(ContactFinder, ThePegOfTheExampleGoesThroughItsEightRelations) {
  const Polyhedron peg =
      BuildPolyhedron(AlongY({{-2, 0}, {2, 0}, {2, 5}, {4, 5}, {4, 7}, {-4, 7}, {-4, 5}, {-2, 5}}, 3));
  const Polyhedron slot =
      BuildPolyhedron(AlongY({{-7, -8}, {7, -8}, {7, 0}, {2, 0}, {2, -6}, {-2, -6}, {-2, 0}, {-7, 0}}, 4));
  const Rotation tilted = Rotation::FromQuaternion(10, 0, 1, 0), upright;
  const auto brief = [&](const Rotation& rotation, const Vector3& translation) {
    return BriefOf(FindContacts(Transform(peg, {rotation, translation}), slot, 0).relation);
  };
  EXPECT_EQ(brief(tilted, {-6, 0, 3}), "300/300/00");
  EXPECT_EQ(brief(tilted, {Rational(-602, 101), 0, Rational(40, 101)}), "210/210/11");
  EXPECT_EQ(brief(tilted, {Rational(-400, 101), 0, Rational(40, 101)}), "singular 300/300/22");
  EXPECT_EQ(brief(tilted, {-2, 0, 0}), "210/210/11");
  const Pose tilted_in{tilted, {Rational(-1196, 10201), 0, Rational(-3880, 10201)}};
  const FoundContacts in = FindContacts(Transform(peg, tilted_in), slot, 0);
  EXPECT_EQ(BriefOf(in.relation), "120/120/22");
  EXPECT_EQ(ComputeMotionDof(in.relation).rotation.detaching_type1, 2);
  EXPECT_EQ(brief(upright, {0, 0, 0}), "singular 300/300/23");
  EXPECT_EQ(brief(upright, {0, 0, -2}), "201/102/12");
  const FoundContacts home = FindContacts(Transform(peg, {upright, {0, 0, -5}}), slot, 0);
  EXPECT_EQ(BriefOf(home.relation), "111/012/23");
  EXPECT_EQ(ComputeMotionDof(home.relation).rotation.detaching_type1, 1);  // it tips over either end
}

// Where the floor meets a wall, one point has a contact with each.
TEST(ContactFinder, APegInTheCornerOfASlotHasTwoContactsAtOnePoint) {
  const FoundContacts found =
      Find(Box({-2, -3, -6}, {1, 3, 1}),
           AlongY({{-7, -8}, {7, -8}, {7, 0}, {2, 0}, {2, -6}, {-2, -6}, {-2, 0}, {-7, 0}}, 4));
  EXPECT_EQ(BriefOf(found.relation), "120/030/23");
  std::multiset<Planes> planes;
  for (const Contact& contact : found.relation.contacts) {
    if (contact.point == Vector3{-2, 3, -6}) planes.insert(PlanesOf(contact));
  }
  EXPECT_EQ(planes, (std::multiset<Planes>{Planes{kX}, Planes{kZ}}));
}

TEST(ContactFinder, WithinTheToleranceALoosePegIsHeldByItsBlindHole) {
  PolygonSoup plate = PlateWithHole();
  for (Vector3& p : plate.points) p = Rational(10) * p;
  const PolygonSoup hole = plate + Box({0, 0, -10}, {60, 60, 0});
  const PolygonSoup peg = Box({21, 21, 0}, {39, 39, 40});
  EXPECT_EQ(BriefOf(Find(peg, hole).relation), "210/120/12");
  const FoundContacts found = Find(peg, hole, 1);
  EXPECT_FALSE(found.relation.singular());
  EXPECT_EQ(BriefOf(found.relation), "012/003/33");
}

TEST(ContactFinder, WithinTheToleranceTiltedFacesTouchInOnePlane) {
  const Pose tilt{Rotation::FromQuaternion(1000, 1, 1, 0), {0, 0, Rational(1, 100)}};
  const Polyhedron moving = Transform(BuildPolyhedron(Box({-2, -2, 0}, {2, 2, 3})), tilt);
  for (const PolygonSoup& fixed : {Table(), Box({-2, -2, -3}, {2, 2, 0})}) {
    const FoundContacts found = FindContacts(moving, BuildPolyhedron(fixed), Rational(1, 10));
    EXPECT_EQ(BriefOf(found.relation), "210/120/12");
    EXPECT_EQ(found.relation.contacts.size(), 4u);
  }
}

}  // namespace
}  // namespace tact::algebra
