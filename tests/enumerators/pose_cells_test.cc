#include "enumerators/pose_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "algebra/error.h"
#include "enumerators/lattice_solid.h"

namespace tact::enumerators {
namespace {

const std::vector<Lattice3> kAxes = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

const std::vector<Lattice3> kAll = {{1, 0, 0},  {0, 1, 0},  {0, 0, 1},  {1, 1, 0},  {1, -1, 0},
                                    {1, 0, 1},  {1, 0, -1}, {0, 1, 1},  {0, 1, -1}, {1, 1, 1},
                                    {1, 1, -1}, {1, -1, 1}, {1, -1, -1}};

std::array<size_t, 4> CountByDimension(const PoseCells& cells) {
  std::array<size_t, 4> count{};
  for (const auto& cell : cells.cells()) ++count.at(static_cast<size_t>(cell.dimension));
  return count;
}

// A vertex, three edges, three squares, a cube.
TEST(PoseCells, AxesCutSpaceIntoCubes) {
  EXPECT_EQ(CountByDimension(PoseCells(kAxes)), (std::array<size_t, 4>{1, 3, 3, 1}));
}

// A square with both diagonals: two vertices, three edges on the sides and four inside... times an interval and its end.
TEST(PoseCells, DiagonalsCutSquaresIntoFour) {
  auto normals = kAxes;
  normals.push_back({1, 1, 0});
  normals.push_back({1, -1, 0});
  // In the plane: corner and centre; two sides, four half diagonals; four triangles.
  EXPECT_EQ(CountByDimension(PoseCells(normals)), (std::array<size_t, 4>{2, 6 + 2, 4 + 6, 4}));
}

// The cells of a torus: their numbers alternate to zero.
TEST(PoseCells, EulerCharacteristicOfATorus) {
  for (size_t n = 3; n <= kAll.size(); ++n) {
    const auto count =
        CountByDimension(PoseCells({kAll.begin(), kAll.begin() + static_cast<std::ptrdiff_t>(n)}));
    EXPECT_EQ(count[0] + count[2], count[1] + count[3]) << n;
  }
}

// An open cell of the cubes has all its sides: 8 vertices, 12 edges, 6 squares.
TEST(PoseCells, ClosureOfACube) {
  const PoseCells cells(kAxes);
  for (size_t g = 0; g < cells.cells().size(); ++g) {
    const size_t expected = static_cast<size_t>(std::pow(3, cells.cells()[g].dimension)) - 1;
    EXPECT_EQ(cells.Closure(g).size(), expected);
  }
}

// Brute force: from a cell's point a straight way into each cell that another point of its neighbourhood lies in.
TEST(PoseCells, StraightWayIntoAClosureStaysInTheCellUntilItsEnd) {
  const PoseCells cells(kAll);
  const auto floors = [&](const algebra::Vector3& p) {
    std::vector<std::pair<std::string, bool>> signs;
    for (const auto& n : kAll) {
      const algebra::Rational value = Dot(algebra::Vector3{n[0], n[1], n[2]}, p);
      // The floor, by counting up: values lie between -3 and 6.
      int floor = -4;
      while (algebra::Rational(floor + 1) <= value) ++floor;
      signs.emplace_back(std::to_string(floor), value.is_integer());
    }
    return signs;
  };
  for (size_t g = 0; g < cells.cells().size(); g += 7) {
    const algebra::Vector3 from = cells.Point(g, {0, 0, 0});
    for (const PoseCells::Side& side : cells.Closure(g)) {
      const algebra::Vector3 to = cells.Point(side.cell, side.offset);
      for (const algebra::Rational& s : {algebra::Rational(1, 2), algebra::Rational(99, 100)}) {
        EXPECT_EQ(floors(from + s * (to - from)), floors(from));
      }
      EXPECT_NE(floors(to), floors(from));
    }
  }
}

TEST(PoseCells, AxesAreWanted) { EXPECT_THROW(PoseCells({{1, 0, 0}, {0, 1, 0}}), PreconditionError); }

TEST(EventNormals, OfBoxesAreTheAxes) {
  const auto box = LatticeSolid({{{0, 0, 0}, {1, 2, 3}}});
  const auto normals = EventNormals(box, box);
  EXPECT_EQ(std::set<Lattice3>(normals.begin(), normals.end()),
            std::set<Lattice3>(kAxes.begin(), kAxes.end()));
}

}  // namespace
}  // namespace tact::enumerators
