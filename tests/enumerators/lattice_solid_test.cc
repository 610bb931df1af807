#include "enumerators/lattice_solid.h"

#include <gtest/gtest.h>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

TEST(LatticeSolid, BlockHasNoSeams) {
  const auto block = LatticeSolid({{{0, 0, 0}, {3, 2, 1}}});
  EXPECT_EQ(block.vertices.size(), 8U);
  EXPECT_EQ(block.edges.size(), 12U);
  EXPECT_EQ(block.faces.size(), 6U);
  EXPECT_EQ(SixfoldVolume(block), algebra::Rational(36));
}

TEST(LatticeSolid, OverlappingBoxesAreOneSolid) {
  const auto ell = LatticeSolid({{{0, 0, 0}, {1, 1, 2}}, {{0, 0, 0}, {2, 1, 1}}});
  EXPECT_EQ(ell.vertices.size(), 12U);
  EXPECT_EQ(ell.faces.size(), 8U);
  EXPECT_EQ(ell.shells, 1U);
  EXPECT_EQ(SixfoldVolume(ell), algebra::Rational(18));
}

TEST(LatticeSolid, HoleIsCarvedThrough) {
  const auto frame = LatticeSolid({{{0, 0, 0}, {3, 3, 1}}}, {{{1, 1, 0}, {2, 2, 1}}});
  EXPECT_EQ(frame.faces.size(), 10U);  // top and bottom with a hole each, four walls outside, four inside
  EXPECT_EQ(frame.vertices.size(), 16U);
  EXPECT_EQ(SixfoldVolume(frame), algebra::Rational(48));
}

TEST(LatticeSolid, NothingIsRefused) {
  EXPECT_THROW(LatticeSolid({}), PreconditionError);
  EXPECT_THROW(LatticeSolid({{{0, 0, 0}, {1, 1, 1}}}, {{{0, 0, 0}, {1, 1, 1}}}), PreconditionError);
}

TEST(LatticeSolid, CubesThatMeetInAnEdgeAreRefused) {
  EXPECT_THROW(LatticeSolid({{{0, 0, 0}, {1, 1, 1}}, {{1, 1, 0}, {2, 2, 1}}}), algebra::SoupError);
}

}  // namespace
}  // namespace tact::enumerators
