#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>

#include "algebra/cone/cone.h"
#include "algebra/exact/linear_algebra.h"
#include "tests/algebra/cone/any_cone.h"
#include "tests/algebra/cone/fourier_motzkin.h"

namespace tact::algebra {
namespace {

std::string Letters(const RowSet& tight) {
  std::string text;
  for (size_t i = 0; i < tight.bound(); ++i) text += tight.Contains(i) ? 'c' : 's';
  return text;
}

RationalRow ToRationals(std::span<const Integer> row) { return {row.begin(), row.end()}; }

// Every string whose equalities and strict inequalities have a solution.
std::vector<std::string> BruteFaces(const HalfspaceCone& cone) {
  std::vector<std::string> faces;
  const size_t rows = cone.inequalities.rows;
  for (size_t bits = 0; bits < size_t{1} << rows; ++bits) {
    FourierMotzkin system;
    std::string face(rows, 'c');
    for (size_t i = 0; i < cone.equalities.rows; ++i) system.Equal(ToRationals(cone.equalities.row(i)));
    for (size_t i = 0; i < rows; ++i) {
      if ((bits >> (rows - 1 - i) & 1) != 0) {
        face[i] = 's';
        system.Positive(ToRationals(cone.inequalities.row(i)));
      } else {
        system.Equal(ToRationals(cone.inequalities.row(i)));
      }
    }
    if (system.Feasible(cone.ambient_dimension())) faces.push_back(face);
  }
  return faces;
}

std::map<size_t, size_t> CountByDimension(const std::vector<ConeFace>& faces) {
  std::map<size_t, size_t> count;
  for (const ConeFace& face : faces) ++count[face.dimension];
  return count;
}

TEST(ConeFaces, OrthantHasABooleanLattice) {
  const std::vector<ConeFace> faces = Faces(Generators(HalfspaceCone(IntegerMatrix::Identity(5))), 5);
  const std::map<size_t, size_t> binomials = {{0, 1}, {1, 5}, {2, 10}, {3, 10}, {4, 5}, {5, 1}};
  EXPECT_EQ(CountByDimension(faces), binomials);
}

TEST(ConeFaces, ConeOverACubeHasTheFacesOfTheCube) {
  IntegerMatrix rows(0, 4);
  for (size_t axis = 1; axis < 4; ++axis) {
    for (const int sign : {1, -1}) {
      IntegerVector row(4);
      row[0] = 1;
      row[axis] = sign;
      rows.AppendRow(row);
    }
  }
  const std::vector<ConeFace> faces = Faces(Generators(HalfspaceCone(rows)), rows.rows);
  const std::map<size_t, size_t> cube = {{0, 1}, {1, 8}, {2, 12}, {3, 6}, {4, 1}};
  EXPECT_EQ(CountByDimension(faces), cube);
}

TEST(ConeFaces, ASubspaceIsItsOnlyFace) {
  const HalfspaceCone line(IntegerMatrix::FromRows({{1, 0}, {-1, 0}}, 2));
  const std::vector<ConeFace> faces = Faces(Generators(line), 2);
  ASSERT_EQ(faces.size(), 1u);
  EXPECT_EQ(faces[0].dimension, 1u);
  EXPECT_EQ(Letters(faces[0].tight), "cc");
}

TEST(ConeFaces, MoreThanOneWordOfRows) {
  // The polygon with 70 sides round a parabola: 70 edges, 70 vertices.
  IntegerMatrix rays(0, 3);
  for (int t = 0; t < 70; ++t) rays.AppendRow(IntegerVector{1, t, t * t});
  const HalfspaceCone facets = Facets({IntegerMatrix(0, 3), rays});
  ASSERT_EQ(facets.inequalities.rows, 70u);
  const std::map<size_t, size_t> polygon = {{0, 1}, {1, 70}, {2, 70}, {3, 1}};
  EXPECT_EQ(CountByDimension(Faces(Generators(facets), 70)), polygon);
}

TEST(ConeFaces, TheVisitorMayStop) {
  const ConeGenerators orthant = Generators(HalfspaceCone(IntegerMatrix::Identity(5)));
  for (size_t stop = 1; stop <= 32; ++stop) {
    size_t seen = 0;
    const bool complete = VisitIntersections(
        orthant.tight, 5, [&](const RowSet&, std::span<const size_t>) { return ++seen < stop; });
    EXPECT_EQ(seen, stop);
    EXPECT_FALSE(complete);
  }
}

RC_GTEST_PROP(ConeFacesBrute, EveryStringTriedByElimination, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(6, 1, 5);
  std::vector<std::string> found;
  for (const ConeFace& face : Faces(Generators(cone), cone.inequalities.rows))
    found.push_back(Letters(face.tight));
  RC_ASSERT(found == BruteFaces(cone));
}

RC_GTEST_PROP(ConeFacesLaw, DimensionIsWhatTheTightRowsLeave, ()) {
  const HalfspaceCone cone = AnyHalfspaceCone(10, 1, 6);
  for (const ConeFace& face : Faces(Generators(cone), cone.inequalities.rows)) {
    IntegerMatrix tight = cone.equalities;
    for (const size_t row : face.tight.ToVector()) tight.AppendRow(cone.inequalities.row(row));
    RC_ASSERT(face.dimension == cone.ambient_dimension() - Rank(tight));
  }
}

RC_GTEST_PROP(ConeFacesLaw, EulersRelation, ()) {
  // The alternating sum over the faces of a cone vanishes unless it is a linear subspace.
  const HalfspaceCone cone = AnyHalfspaceCone(10, 1, 6);
  const ConeGenerators generators = Generators(cone);
  int sum = 0;
  for (const ConeFace& face : Faces(generators, cone.inequalities.rows))
    sum += face.dimension % 2 == 0 ? 1 : -1;
  const bool subspace = generators.cone.rays.rows == 0;
  RC_ASSERT(std::abs(sum) == (subspace ? 1 : 0));
}

}  // namespace
}  // namespace tact::algebra
