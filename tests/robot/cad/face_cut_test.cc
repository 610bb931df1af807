#include "robot/cad/face_cut.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tact::cad {
namespace {

using algebra::Rational;
using algebra::Vector3;
using Loops = std::vector<std::vector<size_t>>;

class Plate {
 public:
  void AddLoop(const std::vector<std::pair<Rational, Rational>>& corners) {
    auto& loop = loops.emplace_back();
    for (const auto& [x, y] : corners) {
      loop.push_back(points.size());
      points.push_back({x, y, x + y});  // tilted
    }
  }
  // Twice the area in the xy-plane.
  Rational Twice(const std::vector<size_t>& loop) const {
    Rational sum;
    for (size_t i = 0; i < loop.size(); ++i) {
      const Vector3 &a = points[loop[i]], &b = points[loop[(i + 1) % loop.size()]];
      sum += a.x * b.y - a.y * b.x;
    }
    return sum;
  }
  auto Cut() const { return CutFace(points, loops, {-1, -1, 1}); }

  std::vector<Vector3> points;
  Loops loops;
};

// Triangles of positive area that add up to the plate less its holes, none twice.
void ExpectCut(const Plate& plate) {
  const auto triangles = plate.Cut();
  ASSERT_TRUE(triangles);
  Rational area, wanted;
  size_t corners = 0;
  for (const auto& loop : plate.loops) wanted += plate.Twice(loop), corners += loop.size();
  for (const auto& t : *triangles) {
    const Rational twice = plate.Twice({t[0], t[1], t[2]});
    EXPECT_GT(twice, Rational(0));
    area += twice;
  }
  EXPECT_EQ(area, wanted);
  EXPECT_EQ(triangles->size(), corners + 2 * (plate.loops.size() - 1) - 2);  // Euler
}

TEST(FaceCut, ASquareWithAHole) {
  Plate plate;
  plate.AddLoop({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  plate.AddLoop({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  ExpectCut(plate);
}

TEST(FaceCut, AnLWithTwoHolesAndStraightCorners) {
  Plate plate;
  plate.AddLoop({{0, 0}, {5, 0}, {10, 0}, {10, 4}, {4, 4}, {4, 10}, {0, 10}});
  plate.AddLoop({{1, 1}, {1, 3}, {3, 3}, {3, 1}});
  plate.AddLoop({{1, 5}, {1, 9}, {2, 7}});
  ExpectCut(plate);
}

// A grid of holes, each a triangle or a square somewhere in its cell.
RC_GTEST_PROP(FaceCut, AnyGridOfHoles, ()) {
  const int columns = *rc::gen::inRange(1, 4), rows = *rc::gen::inRange(1, 4);
  Plate plate;
  plate.AddLoop({{0, 0}, {10 * columns, 0}, {10 * columns, 10 * rows}, {0, 10 * rows}});
  for (int c = 0; c < columns; ++c) {
    for (int r = 0; r < rows; ++r) {
      const int x = 10 * c + *rc::gen::inRange(1, 6), y = 10 * r + *rc::gen::inRange(1, 6);
      if (*rc::gen::arbitrary<bool>()) {
        plate.AddLoop({{x, y}, {x, y + 3}, {x + 3, y + 3}, {x + 3, y}});
      } else {
        plate.AddLoop({{x, y}, {x + *rc::gen::inRange(0, 3), y + 3}, {x + 3, y + 1}});
      }
    }
  }
  ExpectCut(plate);
}

TEST(FaceCut, AHoleOutsideIsRefused) {
  Plate plate;
  plate.AddLoop({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  plate.AddLoop({{3, 3}, {3, 4}, {4, 4}, {4, 3}});
  EXPECT_FALSE(plate.Cut());
}

}  // namespace
}  // namespace tact::cad
