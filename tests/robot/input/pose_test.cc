#include "robot/input/pose.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace tact::input {
namespace {

using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

PoseInput Parse(const std::string& text) { return ParsePoseArgument(text, "--pose"); }

double LargestDifference(const Rotation& a, const Rotation& b) {
  double largest = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) largest = std::max(largest, std::abs(ToDouble(a.rows[i][j] - b.rows[i][j])));
  }
  return largest;
}

const Rotation kQuarterTurnAboutZ{{{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}}};

TEST(PoseInput, AQuaternionNeedNotBeUnitAndIsExact) {
  const PoseInput pose = Parse(R"( {"t":[0,0,"1/3"],"q":[2,0,0,2]})");
  EXPECT_TRUE(pose.exact);
  EXPECT_EQ(pose.pose.rotation, kQuarterTurnAboutZ);
  EXPECT_EQ(pose.pose.translation, (Vector3{0, 0, Rational(1, 3)}));
}

TEST(PoseInput, AMatrixThatIsARotationIsExact) {
  const PoseInput pose = Parse(R"({"t":[1,0,0],"matrix":[["3/5","-4/5",0],[0.8,0.6,0],[0,0,1]]})");
  EXPECT_TRUE(pose.exact);
  EXPECT_EQ(pose.pose.rotation.rows[0], (Vector3{Rational(3, 5), Rational(-4, 5), 0}));
  EXPECT_EQ(pose.pose.translation, (Vector3{1, 0, 0}));
}

TEST(PoseInput, AnAngleIsFloatingAndSaysSo) {
  const PoseInput pose = Parse(R"({"t":[0,0,0],"axis":[0,0,9e200],"angle":1.5707963267948966})");
  EXPECT_FALSE(pose.exact);
  EXPECT_TRUE(IsRotation(pose.pose.rotation));
  EXPECT_LT(LargestDifference(pose.pose.rotation, kQuarterTurnAboutZ), 1e-15);
}

TEST(PoseInput, TheAngleZeroIsExactWhateverTheAxis) {
  const PoseInput pose = Parse(R"({"t":[0,0,0],"axis":[0,0,0],"angle":0})");
  EXPECT_TRUE(pose.exact);
  EXPECT_EQ(pose.pose.rotation, Rotation{});
}

TEST(PoseInput, AMatrixWithinTheErrorIsRoundedToARotation) {
  const PoseInput pose = Parse(R"({"t":[0,0,0],"matrix":[[0,-1,0.0000005],[1,0,0],[0,0,1]]})");
  EXPECT_FALSE(pose.exact);
  EXPECT_TRUE(IsRotation(pose.pose.rotation));
  EXPECT_LT(LargestDifference(pose.pose.rotation, kQuarterTurnAboutZ), 1e-6);
}

TEST(PoseInput, MessagesNameTheOptionOrTheFile) {
  try {
    Parse(R"({"t":[0,0,0],"q":[0,0,0,0]})");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("--pose:1:18: ")) << error.what();
  }
  const auto path = std::filesystem::temp_directory_path() / "tact_pose_test.json";
  std::ofstream(path) << "{\"t\":[0,0,5],\n\"q\":[1,0,0,0]}\n";
  EXPECT_EQ(Parse(path.string()).pose.translation, (Vector3{0, 0, 5}));
  std::filesystem::remove(path);
  EXPECT_THROW(Parse(path.string()), InputError);
}

// The matrix of a random rotation, written with 15 digits, comes back as that rotation.
RC_GTEST_PROP(PoseLaw, AMatrixWrittenInDecimalsComesBack, ()) {
  const auto entry = [] { return Rational(*rc::gen::inRange(-50, 51)); };
  const Rational w = entry(), x = entry(), y = entry(), z = entry();
  RC_PRE(w.sign() != 0 || x.sign() != 0 || y.sign() != 0 || z.sign() != 0);
  const Rotation rotation = Rotation::FromQuaternion(w, x, y, z);
  std::string matrix;
  for (const Vector3& row : rotation.rows) {
    char text[128];
    std::snprintf(text, sizeof text, "%s[%.15g,%.15g,%.15g]", matrix.empty() ? "" : ",", ToDouble(row.x),
                  ToDouble(row.y), ToDouble(row.z));
    matrix += text;
  }
  const PoseInput pose = Parse(R"({"t":[0,0,0],"matrix":[)" + matrix + "]}");
  RC_ASSERT(IsRotation(pose.pose.rotation));
  RC_ASSERT(LargestDifference(pose.pose.rotation, rotation) < 1e-14);
  if (pose.exact) RC_ASSERT(pose.pose.rotation == rotation);
}

// The same turn as an axis and an angle and as the quaternion (cos, sin axis).
RC_GTEST_PROP(PoseLaw, AxisAndAngleAreTheQuaternionsRotation, ()) {
  const int x = *rc::gen::inRange(-9, 10), y = *rc::gen::inRange(-9, 10), z = *rc::gen::inRange(-9, 10);
  RC_PRE(x != 0 || y != 0 || z != 0);
  const int half_tangent = *rc::gen::inRange(1, 20);  // of the angle, times the axis' length
  const double angle = 2 * std::atan2(half_tangent * std::sqrt(x * x + y * y + z * z), 10);
  char text[256];
  std::snprintf(text, sizeof text, R"({"t":[0,0,0],"axis":[%d,%d,%d],"angle":%.17g})", x, y, z, angle);
  const Rotation expected =
      Rotation::FromQuaternion(10, half_tangent * x, half_tangent * y, half_tangent * z);
  RC_ASSERT(LargestDifference(Parse(text).pose.rotation, expected) < 1e-14);
}

}  // namespace
}  // namespace tact::input
