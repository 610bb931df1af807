#include "enumerators/dof_transition_scenes.h"

namespace tact::enumerators {
namespace {

using algebra::MotionPath;
using algebra::Rational;
using algebra::Scene;
using algebra::Vector3;
using Piece = std::vector<Vector3>;
using enum algebra::DofIndex;

Piece Box(const Vector3& low, const Vector3& high) {
  Piece corners;
  for (const Rational& x : {low.x, high.x}) {
    for (const Rational& y : {low.y, high.y}) {
      for (const Rational& z : {low.z, high.z}) corners.push_back({x, y, z});
    }
  }
  return corners;
}

// A bar along x with a rhombic section: edges at the bottom (z = 0), at the top (z = 4), at both sides (y = -1, 1).
Piece Bar() {
  Piece corners;
  for (const int x : {-2, 2}) {
    for (const auto& [y, z] : {std::pair(0, 0), std::pair(1, 2), std::pair(0, 4), std::pair(-1, 2)})
      corners.push_back({x, y, z});
  }
  return corners;
}

// On the bar's end face x = 2, about the height z.
Piece Arm(const Vector3& tip, const Rational& z) {
  const Rational r(1, 4);
  return {tip, {2, r, z + r}, {2, -r, z + r}, {2, -r, z - r}, {2, r, z - r}};
}

Piece Peg() { return Box({-1, -1, 0}, {1, 1, 4}); }
Piece Floor() { return Box({-3, -3, -1}, {3, 3, 0}); }
Piece Ceiling() { return Box({-3, -3, 4}, {3, 3, 5}); }
// Its rim is the bar's bottom edge.
Piece HalfFloor() { return Box({-3, 0, -1}, {3, 3, 0}); }

// Four posts about the peg, not joined; the two at x, y = -1 end at the height `low`, the others at `high`.
std::vector<Piece> Posts(int low, int high) {
  const Rational r(1, 2);
  return {Box({-3, -r, -4}, {-1, r, low}), Box({-r, -3, -4}, {r, -1, low}), Box({1, -r, -4}, {3, r, high}),
          Box({-r, 1, -4}, {r, 3, high})};
}

std::vector<Piece> With(std::vector<Piece> pieces, const std::vector<Piece>& more) {
  pieces.insert(pieces.end(), more.begin(), more.end());
  return pieces;
}

// The pieces stand where the motion ends.
Scene EndingAt(std::vector<Piece> moving, std::vector<Piece> fixed, const MotionPath& path) {
  const algebra::Pose back = path.At(1).Inverse();
  for (Piece& piece : moving) {
    for (Vector3& corner : piece) corner = back * corner;
  }
  return {std::move(moving), std::move(fixed), path};
}

// About the bar's bottom edge, and about the line through its middle.
MotionPath Roll() { return MotionPath::Rotation({0, 0, 0}, {Rational(1, 4), 0, 0}); }
MotionPath Spin() { return MotionPath::Rotation({0, 0, 2}, {Rational(1, 4), 0, 0}); }

}  // namespace

std::vector<DofTransitionScene> DofTransitionScenes() {
  const auto down = MotionPath::Line({0, 0, -1}), up = MotionPath::Line({0, 0, 1});
  const Piece tip_level = Arm({4, 0, 2}, 2), tip_aside = Arm({4, 2, 2}, 2);
  return {
      {kMaintaining, kDetaching, "A bar comes down until an edge lies on the floor.",
       EndingAt({Bar()}, {Floor()}, down)},
      {kMaintaining, kConstraining, "A tilted bar turns upright and gets stuck between floor and ceiling.",
       EndingAt({Bar()}, {Floor(), Ceiling()}, Spin())},
      {kMaintaining, kSingularMaintaining, "A bar's edge comes down on the rim of a block, along it.",
       EndingAt({Bar()}, {HalfFloor()}, down)},
      {kMaintaining, kSingularDetaching,
       "A bar comes down on the floor while the tip of its arm meets a rim.",
       EndingAt({Bar(), tip_level}, {Floor(), Box({4, -1, 0}, {5, 1, 2})}, down)},
      {kMaintaining, kSingularConstraining,
       "A tilted bar turns upright between floor and ceiling while the tip of its arm meets a rim.",
       EndingAt({Bar(), tip_aside}, {Floor(), Ceiling(), Box({Rational(7, 2), 2, 2}, {5, 4, 4})}, Spin())},
      {kDetaching, kConstraining, "A bar rolls on its bottom edge until the top edge meets the ceiling.",
       EndingAt({Bar()}, {Floor(), Ceiling()}, Roll())},
      {kDetaching, kSingularMaintaining,
       "A bar slides on its bottom edge until the edge lies on the rim of the floor.",
       EndingAt({Bar()}, {HalfFloor()}, MotionPath::Line({0, -1, 0}))},
      {kDetaching, kSingularDetaching,
       "A bar slides along floor and wall until the tip of its arm meets an upright edge.",
       EndingAt({Bar(), tip_level}, {Floor(), Box({-3, 1, 0}, {3, 3, 4}), Box({4, 0, 1}, {5, 2, 3})},
                MotionPath::Line({Rational(1, 2), 0, 0}))},
      {kDetaching, kSingularConstraining,
       "A bar rolls on its bottom edge until the top edge meets the ceiling and the tip of its arm a rim.",
       EndingAt({Bar(), tip_aside}, {Floor(), Ceiling(), Box({Rational(7, 2), 2, 2}, {5, 4, 4})}, Roll())},
      {kConstraining, kSingularMaintaining,
       "A bar between two walls rises until both sides are at the walls' rims.",
       EndingAt({Bar()}, {Box({-3, -3, -1}, {3, -1, 2}), Box({-3, 1, -1}, {3, 3, 2})}, up)},
      {kConstraining, kSingularDetaching,
       "A peg rises between four posts until it is level with the rims of the two low ones.",
       EndingAt({Peg()}, Posts(0, 5), up)},
      {kConstraining, kSingularConstraining,
       "A peg rises between four posts until the tip on its head meets a rim.",
       EndingAt({Peg(), {{0, 0, 6}, {1, 1, 4}, {-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}}},
                With(Posts(5, 5), {Box({0, -3, 6}, {3, 3, 7})}), up)},
      {kSingularMaintaining, kSingularDetaching,
       "With the tip of its arm on an upright edge, a bar comes down on the floor.",
       EndingAt({Bar(), tip_level}, {Floor(), Box({4, 0, 0}, {5, 2, 4})}, down)},
      {kSingularConstraining, kSingularMaintaining,
       "With the tip of its arm on an upright edge, a bar between two walls rises until both sides are at "
       "the walls' rims.",
       EndingAt({Bar(), tip_level},
                {Box({-3, -3, -1}, {3, -1, 2}), Box({-3, 1, -1}, {3, 3, 2}), Box({4, 0, 0}, {5, 2, 4})}, up)},
      {kSingularConstraining, kSingularDetaching,
       "With the tip of its head on an upright edge, a peg rises between four posts until it is level with "
       "the rims of the two "
       "low ones.",
       EndingAt({Peg(), {{2, 2, 5}, {1, 1, 4}, {-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}}},
                With(Posts(0, 2), {Box({2, 2, 3}, {4, 4, 7})}), up)},
  };
}

algebra::Scene RollIntoTheCorner() {
  return EndingAt({Bar()}, {Floor(), Ceiling(), Box({-3, -3, 0}, {3, -1, 4})}, Roll());
}

}  // namespace tact::enumerators
