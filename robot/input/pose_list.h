/// @file
/// Recorded pose lists: two models and, scene after scene, where a camera saw each.
/// Model   `No of Models: 2`, a model file a line (the moving one first, then the fixed one; `.\peg.step` lies in the
///         list's folder), `No of Scenes: 41`, then for each scene a line a model,
///           <flag> tx ty tz ax ay az angle
///         with blank lines between scenes. The flag, a whole number, carries nothing.
/// Frames  X_CM and X_CF are the poses of both models in the camera's frame C.
/// Units   locations as written, in the unit that the caller knows the list has (recorded lists: mm); angle in radian.
/// Exact   no: axis and angle are floating.
/// Errors  InputError `file:line:column: expected this, got that`: counts that differ, missing and surplus numbers, an axis
///         whose length is not one to kLargestAxisError, an angle beyond a turn, a location beyond kFarthestListed.
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include "robot/joint/transform.h"

namespace tact::input {

/// How far an axis' length may be from one: six decimals leave 2e-6, a wrong column much more.
inline constexpr double kLargestAxisError = 1e-3;
/// Radian: a turn and the last digits of a rounded one. An angle in degrees is mostly beyond.
inline constexpr double kLargestListedAngle = 6.284;
/// Farther away, whatever the unit, no camera sees; the squares stay in the range of a double.
inline constexpr double kFarthestListed = 1e12;

struct ListedScene {
  joint::Transform X_CM, X_CF;
  std::string where;  // "file:line:column" of its first number
};

struct PoseList {
  std::filesystem::path moving, fixed;
  std::vector<ListedScene> scenes;
};

/// source names the text in messages, and its folder is that of the models.
PoseList ReadPoseList(std::istream& in, const std::string& source);

}  // namespace tact::input
