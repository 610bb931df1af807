#include "robot/input/pose.h"

#include <array>
#include <cmath>
#include <cstdio>

#include "algebra/error.h"
#include "robot/input/json_stream.h"

namespace tact::input {
namespace {

using algebra::Dot;
using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

std::string Short(const Rational& value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", ToDouble(value));
  return text;
}

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

// Refuses what is further from a rotation than kLargestMatrixError, saying in what and how far.
void ExpectNearRotation(const JsonValue& value, const Rotation& matrix) {
  const Rational allowed = Rational::FromShortestDecimal(kLargestMatrixError);
  for (int i = 0; i < 3; ++i) {
    for (int j = i; j < 3; ++j) {
      const Rational product = Dot(matrix.rows[i], matrix.rows[j]);
      if (Abs(product - Rational(i == j ? 1 : 0)) <= allowed) continue;
      const std::string rows =
          i == j ? "row " + std::to_string(i + 1) + " times itself is "
                 : "rows " + std::to_string(i + 1) + " and " + std::to_string(j + 1) + " have the product ";
      value.Fail("expected a rotation matrix, got no rotation: " + rows + Short(product) + ", not " +
                 (i == j ? "1" : "0"));
    }
  }
  if (Dot(Cross(matrix.rows[0], matrix.rows[1]), matrix.rows[2]).sign() < 0) {
    value.Fail("expected a rotation matrix, got no rotation: the determinant is -1 (a mirror image)");
  }
}

// The quaternion of a matrix, from the largest of its four squares: no cancellation [Shepperd, 1978].
Rotation RoundToQuaternion(const Rotation& matrix) {
  double m[3][3];
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) m[i][j] = ToDouble(matrix.rows[i][j]);
  }
  const double trace = m[0][0] + m[1][1] + m[2][2];
  int largest = 0;
  for (int i = 1; i < 3; ++i) {
    if (m[i][i] > m[largest][largest]) largest = i;
  }
  if (trace >= m[largest][largest]) {
    const double w = 1 + trace;  // 4 w^2, all four scaled by 4 w
    return NearestRational(w, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]);
  }
  const int i = largest, j = (i + 1) % 3, k = (i + 2) % 3;
  std::array<double, 3> v{};
  v[i] = 1 + m[i][i] - m[j][j] - m[k][k];
  v[j] = m[j][i] + m[i][j];
  v[k] = m[k][i] + m[i][k];
  return NearestRational(m[k][j] - m[j][k], v[0], v[1], v[2]);
}

PoseInput ParseMatrix(const JsonValue& value) {
  constexpr std::string_view kWanted = "three rows of three numbers";
  Rotation matrix;
  int i = 0;
  if (!value.is_array() || value.size() != 3) value.FailExpected(kWanted);
  for (const JsonValue row : value.Elements(kWanted)) matrix.rows[i++] = row.ReadVector3();
  if (IsRotation(matrix)) return {{matrix, {}}, true};
  ExpectNearRotation(value, matrix);
  return {{RoundToQuaternion(matrix), {}}, false};
}

}  // namespace

PoseInput ParsePose(const JsonValue& value) {
  value.ExpectObject({"t", "q", "axis", "angle", "matrix"});
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
