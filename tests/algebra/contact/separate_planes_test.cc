#include "algebra/contact/separate_planes.h"

#include <gtest/gtest.h>

#include <set>

#include "algebra/cone/cone.h"
#include "tests/algebra/contact/touching_solids.h"

namespace tact::algebra {
namespace {

IntegerVector Row(const Vector3& v) {
  const Vector3 p = Primitive(v);
  return {p.x.numerator(), p.y.numerator(), p.z.numerator()};
}

// The extreme rays of { n | n . a <= 0 for the fixed piece's directions, n . b >= 0 for the moving one's } by double
// description; none if the pieces overlap.
std::set<IntegerVector> ExtremeRays(const ConvexPiece& moving, const ConvexPiece& fixed) {
  std::vector<IntegerVector> rows;
  for (const Vector3& a : fixed.directions) rows.push_back(Row(-a));
  for (const Vector3& b : moving.directions) rows.push_back(Row(b));
  const ConeGenerators generators = Generators(HalfspaceCone(IntegerMatrix::FromRows(rows, 3)));
  EXPECT_EQ(generators.lineality_dimension(), 0u);  // the pieces are full
  std::set<IntegerVector> rays;
  for (size_t i = 0; i < generators.cone.rays.rows; ++i) rays.insert(generators.cone.rays.RowVector(i));
  return rays;
}

std::vector<ConvexPiece> RandomPieces(Dice& dice) {
  for (;;) {
    const Polyhedron solid = Transform(RandomBody(dice).solid, Pose{RandomRotation(dice), {}});
    const Vector3 point = RandomSurfacePoint(dice, solid);
    if (!ElementsAt(solid, point).empty())
      return LocalPieces(solid, point);  // else a face is not convex there
  }
}

TEST(SeparatePlanesTwin, AreTheExtremeRaysOfTheSeparatingNormals) {
  int none = 0, one = 0, several = 0;
  Dice dice(90000);
  for (int i = 0; i < 500; ++i) {
    for (const ConvexPiece& moving : RandomPieces(dice)) {
      for (const ConvexPiece& fixed : RandomPieces(dice)) {
        const std::vector<Vector3> planes = SeparatePlanes(moving, fixed, 0);
        std::set<IntegerVector> rows;
        for (const Vector3& n : planes) rows.insert(Row(n));
        ASSERT_EQ(rows.size(), planes.size()) << "a plane twice";
        ASSERT_EQ(rows, ExtremeRays(moving, fixed)) << i;
        ++(planes.empty() ? none : (planes.size() == 1 ? one : several));
      }
    }
  }
  EXPECT_GT(none, 300);
  EXPECT_GT(one, 10);
  EXPECT_GT(several, 100);
}

// The two forms of a piece are one cone.
TEST(LocalPieces, APointOffTheSurfaceIsRefused) {
  EXPECT_THROW(LocalPieces(BuildPolyhedron(Box({0, 0, 0}, {2, 2, 2})), {1, 1, 1}), PreconditionError);
}

TEST(LocalPiecesTwin, NormalsAreTheFacetsOfTheDirections) {
  Dice dice(91000);
  for (int i = 0; i < 300; ++i) {
    for (const ConvexPiece& piece : RandomPieces(dice)) {
      IntegerMatrix rays(0, 3);
      for (const Vector3& d : piece.directions) rays.AppendRow(Row(d));
      const HalfspaceCone facets = Facets({IntegerMatrix(0, 3), rays});
      std::vector<IntegerVector> normals;
      for (const Vector3& n : piece.normals) normals.push_back(Row(-n));
      ASSERT_EQ(facets.equalities.rows, 0u);
      // Facets reduces nothing where there are no equalities: primitive, in lexicographic order.
      std::set<IntegerVector> expected(normals.begin(), normals.end()), found;
      for (size_t k = 0; k < facets.inequalities.rows; ++k) found.insert(facets.inequalities.RowVector(k));
      ASSERT_EQ(found, expected);
    }
  }
}

// A little step from a point of the surface ends inside exactly if some piece holds its direction strictly.
TEST(LocalPiecesTwin, TheUnionIsWhatTheSolidLooksLike) {
  int inside = 0, outside = 0;
  for (unsigned seed = 92000; seed < 92120; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Dice dice(seed);
    const Cubes cubes = RandomCubes(dice);
    const Polyhedron solid = BuildPolyhedron(dice.Roll(0, 1) == 0 ? cubes.OneShell() : cubes.ManyShells());
    const Vector3 point = solid.vertices[dice.Roll(0, static_cast<int>(solid.vertices.size()) - 1)].point;
    const std::vector<ConvexPiece> pieces = LocalPieces(solid, point);
    for (int i = 0; i < 10; ++i) {
      const Vector3 d = dice.RollVector(-99, 99);
      const auto strictly = [&](const ConvexPiece& piece, bool closed) {
        return std::all_of(piece.normals.begin(), piece.normals.end(),
                           [&](const Vector3& n) { return Dot(n, d).sign() < (closed ? 1 : 0); });
      };
      const bool held =
          std::any_of(pieces.begin(), pieces.end(), [&](const ConvexPiece& p) { return strictly(p, false); });
      const bool closed =
          std::any_of(pieces.begin(), pieces.end(), [&](const ConvexPiece& p) { return strictly(p, true); });
      if (held != closed) continue;  // between pieces or on the surface
      const Side side = Locate(solid, point + Rational(1, 1000000) * d);
      ASSERT_EQ(side, held ? Side::kInside : Side::kOutside) << ToString(d);
      ++(held ? inside : outside);
    }
  }
  EXPECT_GT(inside, 200);
  EXPECT_GT(outside, 200);
}

}  // namespace
}  // namespace tact::algebra
