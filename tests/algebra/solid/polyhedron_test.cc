#include "algebra/solid/polyhedron.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "tests/algebra/solid/solids.h"

namespace tact::algebra {
namespace {

size_t Count(const Polyhedron& solid, Convexity convexity) {
  return static_cast<size_t>(std::count_if(solid.edges.begin(), solid.edges.end(),
                                           [&](const Edge& e) { return e.convexity == convexity; }));
}

// What the header says of every polyhedron.
void ExpectConsistent(const Polyhedron& solid) {
  std::vector<int> left(solid.edges.size()), right(solid.edges.size());
  for (size_t f = 0; f < solid.faces.size(); ++f) {
    const Face& face = solid.faces[f];
    ASSERT_EQ(face.loops.size(), face.loop_edges.size());
    EXPECT_EQ(Primitive(face.normal), face.normal);
    for (size_t l = 0; l < face.loops.size(); ++l) {
      const auto& loop = face.loops[l];
      Vector3 area;
      for (size_t i = 0; i < loop.size(); ++i) {
        const Vertex& from = solid.vertices[loop[i]];
        const Vertex& to = solid.vertices[loop[(i + 1) % loop.size()]];
        EXPECT_EQ(Dot(face.normal, from.point), face.offset);
        EXPECT_EQ(from.shell, face.shell);
        area = area + Cross(from.point, to.point);
        const size_t e = face.loop_edges[l][i];
        const Edge& edge = solid.edges[e];
        const bool forward = edge.left == f && edge.tail == loop[i];
        EXPECT_EQ(forward ? edge.head : edge.tail, loop[(i + 1) % loop.size()]);
        EXPECT_EQ(forward ? edge.tail : edge.head, loop[i]);
        EXPECT_EQ(forward ? edge.left : edge.right, f);
        ++(forward ? left : right)[e];
      }
      EXPECT_EQ(Dot(area, face.normal).sign(), l == 0 ? 1 : -1) << "face " << f << " loop " << l;
    }
  }
  EXPECT_EQ(std::set<int>(left.begin(), left.end()), std::set<int>{1});
  EXPECT_EQ(std::set<int>(right.begin(), right.end()), std::set<int>{1});
  for (size_t v = 0; v < solid.vertices.size(); ++v) {
    const Vertex& vertex = solid.vertices[v];
    ASSERT_EQ(vertex.edges.size(), vertex.faces.size());
    ASSERT_GE(vertex.edges.size(), 3u);
    for (size_t i = 0; i < vertex.edges.size(); ++i) {
      // Walking away from the vertex along edges[i], faces[i] is on the left and faces[i - 1] on the right.
      const Edge& edge = solid.edges[vertex.edges[i]];
      ASSERT_TRUE(edge.tail == v || edge.head == v);
      const size_t before = vertex.faces[(i + vertex.faces.size() - 1) % vertex.faces.size()];
      EXPECT_EQ(edge.tail == v ? edge.left : edge.right, vertex.faces[i]);
      EXPECT_EQ(edge.tail == v ? edge.right : edge.left, before);
    }
  }
}

// V - E + F - H = 2 (1 - genus), summed over the shells, H counting the holes in faces.
long EulerNumber(const Polyhedron& solid) {
  long holes = 0;
  for (const Face& face : solid.faces) holes += static_cast<long>(face.loops.size()) - 1;
  return static_cast<long>(solid.vertices.size()) - static_cast<long>(solid.edges.size()) +
         static_cast<long>(solid.faces.size()) - holes;
}

TEST(Polyhedron, CubeHasEightCornersTwelveConvexEdgesSixFaces) {
  const Polyhedron cube = BuildPolyhedron(Box({0, 0, 0}, {1, 1, 1}));
  ExpectConsistent(cube);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(Count(cube, Convexity::kConvex), 12u);
  EXPECT_EQ(cube.edges.size(), 12u);
  EXPECT_EQ(cube.faces.size(), 6u);
  EXPECT_EQ(cube.shells, 1u);
  EXPECT_EQ(SixfoldVolume(cube), Rational(6));
}

TEST(Polyhedron, FacesAroundACornerOfTheCubeRunCounterClockwiseSeenFromOutside) {
  const Polyhedron cube = BuildPolyhedron(Box({0, 0, 0}, {1, 1, 1}));
  const auto corner = std::find_if(cube.vertices.begin(), cube.vertices.end(), [](const Vertex& v) {
    return v.point == Vector3{1, 1, 1};
  });
  ASSERT_EQ(corner->faces.size(), 3u);
  const auto normal = [&](size_t i) { return cube.faces[corner->faces[i]].normal; };
  EXPECT_EQ(Dot(Cross(normal(0), normal(1)), normal(2)), Rational(1));  // +x, +y, +z in cyclic order
}

TEST(Polyhedron, TriangulatedCubeIsTheQuadCube) {
  const PolygonSoup quads = Box({0, 0, 0}, {1, 1, 1});
  const Polyhedron a = BuildPolyhedron(quads), b = BuildPolyhedron(Triangulated(quads));
  ExpectConsistent(b);
  ASSERT_EQ(a.faces.size(), b.faces.size());
  for (size_t f = 0; f < a.faces.size(); ++f) {
    EXPECT_EQ(a.faces[f].normal, b.faces[f].normal);
    EXPECT_EQ(a.faces[f].offset, b.faces[f].offset);
    EXPECT_EQ(a.faces[f].loops[0].size(), 4u);
    EXPECT_EQ(b.faces[f].loops[0].size(), 4u);
  }
  EXPECT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_EQ(a.edges.size(), b.edges.size());
}

TEST(Polyhedron, TrianglesWithoutCommonPointsMakeTheSameCube) {
  const PolygonSoup triangles = Triangulated(Box({0, 0, 0}, {1, 1, 1}));
  PolygonSoup apart;
  for (const auto& polygon : triangles.polygons) {
    apart.polygons.emplace_back();
    for (const size_t corner : polygon) {
      apart.polygons.back().push_back(apart.points.size());
      apart.points.push_back(triangles.points[corner]);
    }
  }
  const Polyhedron cube = BuildPolyhedron(apart);
  ExpectConsistent(cube);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.faces.size(), 6u);
}

TEST(Polyhedron, LPrismHasOneConcaveEdge) {
  const Polyhedron prism = BuildPolyhedron(Prism({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 2));
  ExpectConsistent(prism);
  EXPECT_EQ(prism.vertices.size(), 12u);
  EXPECT_EQ(prism.edges.size(), 18u);
  EXPECT_EQ(prism.faces.size(), 8u);
  EXPECT_EQ(Count(prism, Convexity::kConcave), 1u);
  for (const Edge& edge : prism.edges) {
    const Vector3& p = prism.vertices[edge.tail].point;
    const Vector3& q = prism.vertices[edge.head].point;
    const bool inner = p.x == Rational(1) && p.y == Rational(1) && q.x == Rational(1) && q.y == Rational(1);
    EXPECT_EQ(edge.convexity == Convexity::kConcave, inner);
  }
  EXPECT_EQ(SixfoldVolume(prism), Rational(6 * 5 * 2));
}

TEST(Polyhedron, PlateWithHoleHasTwoFacesWithAHole) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  ExpectConsistent(plate);
  EXPECT_EQ(plate.vertices.size(), 16u);
  EXPECT_EQ(plate.edges.size(), 24u);
  EXPECT_EQ(plate.faces.size(), 10u);
  EXPECT_EQ(std::count_if(plate.faces.begin(), plate.faces.end(),
                          [](const Face& f) { return f.loops.size() == 2; }),
            2);
  EXPECT_EQ(Count(plate, Convexity::kConcave), 4u);  // the hole's upright edges
  EXPECT_EQ(EulerNumber(plate), 0);                  // genus 1
  EXPECT_EQ(SixfoldVolume(plate), Rational(6 * (36 - 4) * 2));
}

TEST(Polyhedron, CavityIsAShellOfItsOwnAndSubtracts) {
  const Polyhedron solid = BuildPolyhedron(Box({0, 0, 0}, {4, 4, 4}) + Reversed(Box({1, 1, 1}, {2, 2, 2})));
  ExpectConsistent(solid);
  EXPECT_EQ(solid.shells, 2u);
  EXPECT_EQ(SixfoldVolume(solid), Rational(6 * (64 - 1)));
  EXPECT_EQ(Count(solid, Convexity::kConcave), 12u);
  EXPECT_EQ(EulerNumber(solid), 4);
}

TEST(Polyhedron, ABodyInACavityIsKept) {
  const PolygonSoup hollow = Box({0, 0, 0}, {9, 9, 9}) + Reversed(Box({1, 1, 1}, {8, 8, 8}));
  EXPECT_EQ(BuildPolyhedron(hollow + Box({3, 3, 3}, {4, 4, 4})).shells, 3u);
  EXPECT_EQ(BuildPolyhedron(hollow + Box({1, 3, 3}, {4, 4, 4})).shells, 3u);  // touches the cavity's wall
  EXPECT_NE(Refusal(hollow + Box({0, 3, 3}, {4, 4, 4})), "");                 // pierces it
}

TEST(Polyhedron, BodiesThatTouchAreTwoShells) {
  const PolygonSoup cube = Box({0, 0, 0}, {2, 2, 2});
  for (const PolygonSoup& other :
       {Box({0, 0, 2}, {2, 2, 3}), Box({1, 1, 2}, {3, 3, 3}), Box({Rational(1, 2), 1, 2}, {1, 2, 3}),
        Box({2, 2, 0}, {3, 3, 2}), Box({2, 2, 2}, {3, 3, 3}), Box({2, 1, 1}, {4, 5, 6})}) {
    const Polyhedron both = BuildPolyhedron(cube + other);
    ExpectConsistent(both);
    EXPECT_EQ(both.shells, 2u);
    EXPECT_EQ(both.vertices.size(), 16u);
    EXPECT_EQ(both.faces.size(), 12u);
  }
}

TEST(Polyhedron, StraightThroughCornersDisappear) {
  PolygonSoup cube = Box({0, 0, 0}, {2, 2, 2});
  cube.points.push_back({1, 0, 0});  // on the edge of polygons 0 and 2
  cube.polygons[0] = {0, 2, 3, 1, 8};
  cube.polygons[2] = {0, 8, 1, 5, 4};
  const Polyhedron solid = BuildPolyhedron(cube);
  ExpectConsistent(solid);
  EXPECT_EQ(solid.vertices.size(), 8u);
  EXPECT_EQ(solid.edges.size(), 12u);
}

// A pit whose rim touches the top's edge at (2, 0, 2): one corner, at which the top appears twice.
TEST(Polyhedron, AFaceThatTouchesItselfAtACornerHasOneLoopThroughItTwice) {
  PolygonSoup soup = Box({0, 0, 0}, {4, 4, 2});
  soup.points.insert(soup.points.end(), {{2, 0, 2}, {3, 2, 2}, {1, 2, 2}, {2, Rational(3, 2), 1}});
  soup.polygons[2] = {0, 1, 5, 8, 4};
  soup.polygons[1] = {4, 8, 10, 6};
  const std::vector<std::vector<size_t>> added = {
      {8, 5, 7, 9}, {6, 10, 9, 7}, {10, 8, 11}, {9, 10, 11}, {8, 9, 11}};
  soup.polygons.insert(soup.polygons.end(), added.begin(), added.end());
  const Polyhedron solid = BuildPolyhedron(soup);
  ExpectConsistent(solid);
  EXPECT_EQ(solid.vertices.size(), 12u);
  EXPECT_EQ(solid.edges.size(), 19u);
  EXPECT_EQ(solid.faces.size(), 9u);
  EXPECT_EQ(Count(solid, Convexity::kConcave), 3u);  // down the pit
  EXPECT_EQ(solid.faces[1].loops.size(), 1u);
  EXPECT_EQ(solid.faces[1].loops[0].size(), 8u);
  const auto rim = std::find_if(solid.vertices.begin(), solid.vertices.end(), [](const Vertex& v) {
    return v.point == Vector3{2, 0, 2};
  });
  EXPECT_EQ(std::count(rim->faces.begin(), rim->faces.end(), size_t{1}), 2);
  EXPECT_EQ(rim->faces.size(), 5u);
  EXPECT_EQ(SixfoldVolume(solid), Rational(6 * 32 - 4));  // the pit: base 2, depth 1
}

TEST(Polyhedron, TwoPitsThatTouchAtACornerAreOneHoleOfTheTop) {
  PolygonSoup soup = Box({0, 0, 0}, {4, 4, 2});
  soup.points.insert(soup.points.end(),
                     {{2, 2, 2}, {1, 1, 2}, {3, 1, 2}, {1, 3, 2}, {3, 3, 2}, {2, 1, 1}, {2, 3, 1}});
  soup.polygons.erase(soup.polygons.begin() + 1);
  const std::vector<std::vector<size_t>> added = {
      {4, 5, 10, 9}, {5, 7, 12, 8, 10}, {7, 6, 11, 12}, {6, 4, 9, 8, 11}, {9, 10, 13},
      {10, 8, 13},   {8, 9, 13},        {12, 11, 14},   {8, 12, 14},      {11, 8, 14}};
  soup.polygons.insert(soup.polygons.end(), added.begin(), added.end());
  const Polyhedron solid = BuildPolyhedron(soup);
  ExpectConsistent(solid);
  EXPECT_EQ(solid.vertices.size(), 15u);
  const auto top = std::find_if(solid.faces.begin(), solid.faces.end(), [](const Face& f) {
    return f.normal == Vector3{0, 0, 1};
  });
  ASSERT_EQ(top->loops.size(), 2u);
  EXPECT_EQ(top->loops[1].size(), 6u);
  EXPECT_EQ(SixfoldVolume(solid), Rational(6 * 32 - 2 * 2));
}

TEST(Polyhedron, TransformCarriesEveryPlaneAndKeepsTheVolume) {
  const Polyhedron plate = BuildPolyhedron(PlateWithHole());
  const Pose X{Rotation::FromQuaternion(1, 2, 3, 4), {Rational(1, 7), -2, 5}};
  const Polyhedron moved = Transform(plate, X);
  ExpectConsistent(moved);
  EXPECT_EQ(SixfoldVolume(moved), SixfoldVolume(plate));
}

// The tetrahedron on four random points, turned outwards.
RC_GTEST_PROP(PolyhedronLaw, RandomTetrahedraAreAccepted, ()) {
  PolygonSoup soup;
  for (int i = 0; i < 4; ++i) {
    soup.points.push_back({*rc::gen::inRange(-9, 9),
                           Rational(*rc::gen::inRange(-9, 9), *rc::gen::inRange(1, 5)),
                           *rc::gen::inRange(-9, 9)});
  }
  soup.polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  const Vector3& o = soup.points[0];
  const Rational volume = Dot(Cross(soup.points[1] - o, soup.points[2] - o), soup.points[3] - o);
  if (volume.sign() == 0) {
    RC_ASSERT(!Refusal(soup).empty());
    return;
  }
  RC_ASSERT(Refusal(volume.sign() > 0 ? Reversed(soup) : soup).find("inverted") != std::string::npos);
  const Polyhedron solid = BuildPolyhedron(volume.sign() > 0 ? soup : Reversed(soup));
  RC_ASSERT(SixfoldVolume(solid) == Abs(volume));
  RC_ASSERT(solid.vertices.size() == 4u && solid.edges.size() == 6u && solid.faces.size() == 4u);
  RC_ASSERT(std::all_of(solid.edges.begin(), solid.edges.end(),
                        [](const Edge& e) { return e.convexity == Convexity::kConvex; }));
}

// A hull by brute force: a triple of points is a polygon if all others are below its plane.
RC_GTEST_PROP(PolyhedronLaw, HullsAreConvexAndOfGenusZero, ()) {
  std::set<Vector3> distinct;
  for (int i = 0; i < 9; ++i) {
    distinct.insert({*rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4), *rc::gen::inRange(-3, 4)});
  }
  PolygonSoup soup{{distinct.begin(), distinct.end()}, {}};
  const auto& p = soup.points;
  std::set<std::pair<Vector3, Rational>> planes;
  for (size_t i = 0; i < p.size(); ++i) {
    for (size_t j = 0; j < p.size(); ++j) {
      for (size_t k = 0; k < p.size(); ++k) {
        const Vector3 normal = Primitive(Cross(p[j] - p[i], p[k] - p[i]));
        const Rational offset = Dot(normal, p[i]);
        if (normal.IsZero() ||
            std::any_of(p.begin(), p.end(), [&](const Vector3& q) { return Dot(normal, q) > offset; })) {
          continue;
        }
        planes.insert({normal, offset});
      }
    }
  }
  RC_PRE(planes.size() >= 4u);
  for (const auto& plane : planes) {
    const auto& normal = plane.first;  // a name of its own: clang 14 cannot capture a structured binding
    const auto& offset = plane.second;
    std::vector<size_t> on;
    for (size_t i = 0; i < p.size(); ++i) {
      if (Dot(normal, p[i]) == offset) on.push_back(i);
    }
    // Extreme points only, sorted around the first one; points within edges stay out.
    std::vector<size_t> corners;
    for (const size_t i : on) {
      for (const size_t j : on) {
        if (i == j || !std::all_of(on.begin(), on.end(), [&](size_t k) {
              const Vector3 turn = Cross(p[j] - p[i], p[k] - p[i]);
              return turn.IsZero() ? Dot(p[k] - p[i], p[k] - p[j]).sign() <= 0 : Dot(turn, normal).sign() > 0;
            })) {
          continue;
        }
        corners.push_back(i);
        corners.push_back(j);
      }
    }
    std::vector<size_t> polygon{corners[0]};
    while (polygon.size() < corners.size() / 2) {
      for (size_t e = 0; e < corners.size(); e += 2) {
        if (corners[e] == polygon.back()) {
          polygon.push_back(corners[e + 1]);
          break;
        }
      }
    }
    soup.polygons.push_back(polygon);
  }
  const Polyhedron hull = BuildPolyhedron(soup);
  ExpectConsistent(hull);
  RC_ASSERT(EulerNumber(hull) == 2);
  RC_ASSERT(hull.faces.size() == planes.size());
  RC_ASSERT(Count(hull, Convexity::kConcave) == 0u);
  RC_ASSERT(BuildPolyhedron(Triangulated(soup)).edges.size() == hull.edges.size());
}

}  // namespace
}  // namespace tact::algebra
