#include "robot/input/pose.h"

#include <array>
#include <cmath>

#include "algebra/error.h"
#include "robot/input/json_stream.h"
#include "robot/input/rotation_quaternion.h"

namespace tact::input {
namespace {

using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

Rotation NearestRational(double w, double x, double y, double z) {
  return Rotation::FromQuaternion(Rational::FromShortestDecimal(w), Rational::FromShortestDecimal(x),
                                  Rational::FromShortestDecimal(y), Rational::FromShortestDecimal(z));
}

Rotation ParseQuaternion(const JsonValue& value) {
  const std::vector<Rational> q = value.ReadNumbers(4, "[w, x, y, z]");
  bool zero = true;
  for (const Rational& entry : q) zero = zero && entry.sign() == 0;
  if (zero)
    value.Fail("expected a quaternion that is not zero, got [0, 0, 0, 0]; no rotation is [1, 0, 0, 0]");
  return Rotation::FromQuaternion(q[0], q[1], q[2], q[3]);
}

PoseInput ParseAxisAngle(const JsonValue& axis_value, const JsonValue& angle_value) {
  const Vector3 axis = axis_value.ReadVector3();
  const Rational angle_exact = angle_value.ReadRational();
  if (angle_exact.sign() == 0) return {};
  const double angle = ToDouble(angle_exact);
  if (!std::isfinite(angle)) angle_value.FailExpected("an angle in radian");
  Rational largest;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, Abs(axis[i]));
  if (largest.sign() == 0) axis_value.Fail("expected an axis that is not zero, got [0, 0, 0]");
  // Scaled exactly first, so that no length overflows.
  const std::array<double, 3> direction = ToDouble((Rational(1) / largest) * axis);
  const double scale = std::sin(angle / 2) / std::hypot(direction[0], direction[1], direction[2]);
  return {
      {NearestRational(std::cos(angle / 2), scale * direction[0], scale * direction[1], scale * direction[2]),
       {}},
      false};
}

RotationRows RowsOf(const Rotation& matrix) {
  RotationRows rows;
  for (int i = 0; i < 3; ++i) rows[i] = ToDouble(matrix.rows[i]);
  return rows;
}

PoseInput ParseMatrix(const JsonValue& value) {
  constexpr std::string_view kWanted = "three rows of three numbers";
  Rotation matrix;
  int i = 0;
  if (!value.is_array() || value.size() != 3) value.FailExpected(kWanted);
  for (const JsonValue row : value.Elements(kWanted)) matrix.rows[i++] = row.ReadVector3();
  if (IsRotation(matrix)) return {{matrix, {}}, true};
  const RotationRows rows = RowsOf(matrix);
  if (const auto fault = RotationFault(rows, kLargestMatrixError))
    value.Fail("expected a rotation matrix, got no rotation: " + *fault);
  const auto [w, x, y, z] = QuaternionOf(rows);
  return {{NearestRational(w, x, y, z), {}}, false};
}

// The members that every pose has.
PoseInput ParseMembers(const JsonValue& value) {
  const Vector3 translation = value.At("t").ReadVector3();
  const auto q = value.Find("q"), axis = value.Find("axis"), angle = value.Find("angle"),
             matrix = value.Find("matrix");
  const int forms = (q ? 1 : 0) + (axis || angle ? 1 : 0) + (matrix ? 1 : 0);
  if (forms != 1) {
    value.Fail(
        std::string(
            "expected one rotation, as \"q\":[w,x,y,z], as \"axis\" and \"angle\" or as \"matrix\", got ") +
        (forms == 0 ? "none; no rotation is \"q\":[1,0,0,0]" : "several"));
  }
  PoseInput input;
  if (q) input.pose.rotation = ParseQuaternion(*q);
  if (axis || angle) input = ParseAxisAngle(value.At("axis"), value.At("angle"));
  if (matrix) input = ParseMatrix(*matrix);
  input.pose.translation = translation;
  return input;
}

}  // namespace

PoseInput ParsePose(const JsonValue& value) {
  value.ExpectObject({"t", "q", "axis", "angle", "matrix"});
  return ParseMembers(value);
}

TimedPoseInput ParseTimedPose(const JsonValue& value) {
  value.ExpectObject({"time", "t", "q", "axis", "angle", "matrix"});
  TimedPoseInput input{ParseMembers(value), std::nullopt};
  if (const auto time = value.Find("time")) input.time = time->ReadRational();
  return input;
}

PoseInput ParsePoseArgument(const std::string& argument, const std::string& option) {
  const size_t first = argument.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) {
    throw InputError(option + ": expected a pose in JSON or the name of a file of it, got nothing");
  }
  const bool is_text = argument[first] == '{';
  const JsonDocument document = is_text ? JsonDocument::Parse(argument, option) : ReadJsonFile(argument);
  return ParsePose(document.root());
}

}  // namespace tact::input
