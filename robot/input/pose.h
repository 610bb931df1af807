/// @file
/// Poses as text.
/// Model   {"t":[x,y,z],"q":[w,x,y,z]}, {"t":..,"axis":[x,y,z],"angle":radian} or
/// {"t":..,"matrix":[[..],[..],[..]]} (rows);
///         axis and quaternion need not be unit.
/// Exact   a quaternion always; a matrix that is a rotation in rationals; an angle of 0. Any other rotation
/// becomes the
///         rational quaternion of its double quaternion's shortest decimals, and says exact = false.
/// Errors  InputError: a zero quaternion or axis; a matrix that is no rotation by more than
/// kLargestMatrixError.
#pragma once

#include <optional>
#include <string>

#include "algebra/screw/pose.h"
#include "robot/input/json_value.h"

namespace tact::input {

/// How far a product of two rows may be from that of a rotation: matrices are written with six digits and
/// more.
inline constexpr double kLargestMatrixError = 1e-6;

struct PoseInput {
  algebra::Pose pose;
  bool exact = true;  // the pose is the very one that was written
};

PoseInput ParsePose(const JsonValue& value);

struct TimedPoseInput : PoseInput {
  std::optional<algebra::Rational> time;
};

/// A pose that may have a "time" beside it.
TimedPoseInput ParseTimedPose(const JsonValue& value);

/// From the command line: the text itself if it begins with '{', otherwise a file's name; option names it in
/// messages.
PoseInput ParsePoseArgument(const std::string& argument, const std::string& option);

}  // namespace tact::input
