/// @file
/// Scenes with planes and touches of every kind; how many contacts each end has was counted by hand.
#pragma once

#include <ostream>
#include <string>
#include <vector>

#include "algebra/contact/scene.h"
#include "tests/algebra/solid/solids.h"

namespace tact::provers {

using algebra::MotionPath;
using algebra::Rational;
using algebra::Scene;
using algebra::Vector3;

struct NamedScene {
  std::string name;
  Scene scene;
  size_t contacts_before, contacts_after;
};
inline void PrintTo(const NamedScene& scene, std::ostream* out) { *out << scene.name; }

inline std::vector<Vector3> Corners(const Vector3& low, const Vector3& high) {
  return algebra::Box(low, high).points;
}

inline std::vector<Vector3> Carried(std::vector<Vector3> points, const algebra::Pose& X) {
  for (Vector3& p : points) p = X * p;
  return points;
}

inline std::vector<Vector3> PrismCorners(const std::vector<std::pair<Rational, Rational>>& outline) {
  return algebra::Prism(outline, 0, 1).points;
}

inline algebra::Pose Turn(int w, int x, int y, int z) {
  return {algebra::Rotation::FromQuaternion(w, x, y, z), {}};
}

inline std::vector<NamedScene> PathScenes() {
  const std::vector<Vector3> table = Corners({-3, -3, -1}, {3, 3, 0});
  const Rational half(1, 2), third(1, 3);
  return {
      {"BlockDropsOnTable", {{Corners({0, 0, 2}, {1, 1, 3})}, {table}, MotionPath::Line({0, 0, -2})}, 0, 4},
      {"BlockSlidesOverTheBorder",
       {{Corners({-1, -1, 0}, {1, 1, 1})},
        {Corners({-3, -3, -1}, {half, 3, 0})},
        MotionPath::Line({Rational(3, 2), 0, 0})},
       4,
       2},
      {"BarTurnsBetweenWalls",
       {{Carried(PrismCorners({{0, -2}, {Rational(1, 4), 0}, {0, 2}, {Rational(-1, 4), 0}}),
                 Turn(3, 0, 0, -1))},
        {Corners({-9, 2, 0}, {9, 3, 1}), Corners({-9, -3, 0}, {9, -2, 1})},
        MotionPath::Rotation({0, 0, 0}, {0, 0, third})},
       0,
       4},
      {"TiltedBlockLiesDown",
       {{Carried(Corners({0, 0, 0}, {2, 1, 1}), Turn(2, 0, -1, 0))},
        {table},
        MotionPath::Rotation({0, 0, 0}, {0, half, 0})},
       2,
       4},
      {"PegReachesTheGround",
       {{Corners({0, 0, 0}, {1, 1, 4})},
        {Corners({-2, 0, -2}, {0, 1, 1}), Corners({1, 0, -2}, {3, 1, 1}), Corners({-2, 0, -4}, {3, 1, -2})},
        MotionPath::Line({0, 0, -2})},
       8,
       12},
      {"CrossedEdgesSlideToAnEnd",
       {{{{-2, -1, 1}, {-2, 1, 1}, {-2, 0, 0}, {2, -1, 1}, {2, 1, 1}, {2, 0, 0}}},
        {{{-1, -2, -1}, {1, -2, -1}, {0, -2, 0}, {-1, 2, -1}, {1, 2, -1}, {0, 2, 0}}},
        MotionPath::Line({2, 0, 0})},
       1,
       1},
      {"PlateTurnsAboutAFixedEdge",
       {{Corners({-3, -3, 0}, {3, 3, 1})},
        {Carried(Corners({0, 0, -1}, {2, 1, 0}), Turn(2, 0, 1, 0))},
        MotionPath::Rotation({0, 0, 0}, {0, half, 0})},
       2,
       4},
      {"WedgeGoesRoundACorner",
       {{PrismCorners({{Rational(19, 10), 0},
                       {Rational(12, 5), -half},
                       {Rational(29, 10), 0},
                       {Rational(12, 5), half}})},
        {Corners({-1, -1, 0}, {1, 1, 1})},
        MotionPath::Rotation({0, 0, 0}, {0, 0, 1})},
       0,
       0},
      {"TipLandsOnTip",
       {{{{0, 0, 1}, {1, 1, 3}, {-1, 1, 3}, {-1, -1, 3}, {1, -1, 3}}},
        {{{0, 0, 0}, {2, 2, -1}, {-2, 2, -1}, {-2, -2, -1}, {2, -2, -1}}},
        MotionPath::Line({0, 0, -1})},
       0,
       1},
      {"BlockTurnsToTheWall",
       {{Carried(Corners({0, 0, 0}, {2, 1, 1}), Turn(2, 0, 0, 1))},
        {Corners({-5, -5, -1}, {5, 5, 0}), Corners({-5, -2, 0}, {5, 0, 2})},
        MotionPath::Rotation({0, 0, 0}, {0, 0, -half})},
       6,
       8},
  };
}

}  // namespace tact::provers
