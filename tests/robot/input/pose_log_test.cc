#include "robot/input/pose_log.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <sstream>

#include "algebra/error.h"

namespace tact::input {
namespace {

PoseLog Read(const std::string& text, const PoseLogOptions& options = {}) {
  std::istringstream in(text);
  return ReadPoseLog(in, "log", options);
}

void ExpectPose(const LoggedPose& pose, double time, const std::array<double, 3>& location,
                const std::array<double, 4>& rotation) {
  EXPECT_NEAR(pose.time, time, 1e-9);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(pose.location[i], location[i], 1e-12);
  double dot = 0;  // q and -q are one rotation
  for (int i = 0; i < 4; ++i) dot += pose.rotation[i] * rotation[i];
  EXPECT_NEAR(std::abs(dot), 1, 1e-12);
}

// A quarter turn about z, written in every form.
TEST(PoseLog, EveryFormSaysTheSame) {
  const double h = std::sqrt(0.5);
  const std::string z = "0.70710678118654757";
  const struct {
    std::string text;
    std::string description;
    bool timed;
  } logs[] = {
      {"# door\n2.5 1 2 3 0 0 " + z + " " + z + "\n", "TUM lines", true},
      {"\n1 2 3 0 0 " + z + " " + z + "\n", "lines x y z qx qy qz qw", false},
      {"1\t2  3 0 0 1 1\r\n", "lines x y z qx qy qz qw", false},
      {"1 2 3 0 0 -1 -1", "lines x y z qx qy qz qw", false},
      {"0 -1 0 1 1 0 0 2 0 0 1 3\n", "KITTI lines", false},
      {"time,x,y,z,qx,qy,qz,qw\n2.5,1,2,3,0,0,1,1\n", "a table with a header", true},
      {"qw; qx; qy; qz; speed; z; y; x\n1;0;0;1;;3;2;1\n", "a table with a header", false},
      {"# x y z qw qx qy qz\n1 2 3 1 0 0 1\n", "a table with a header", false},
      {"#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z [],"
       "v_RS_R_x [m s^-1],b_w_RS_S_x [rad s^-1]\n2500000000,1,2,3,1,0,0,1,9,9\n",
       "a table with a header", true},
      {"%time,field.pose.position.x,field.pose.position.y,field.pose.position.z,field.pose.orientation.x,"
       "field.pose.orientation.y,field.pose.orientation.z,field.pose.orientation.w\n2.5,1,2,3,0,0,1,1\n",
       "a table with a header", true},
      {"Time [ms], X (mm), Y (mm), Z (mm), Rot_X, Rot_Y, Rot_Z, Rot_W\n2500,1000,2000,3000,0,0,1,1\n",
       "a table with a header", true},
      {"{\"t\":[1,2,3],\"q\":[1,0,0,1]}\n", "JSON lines", false},
      {"{\"time\":2.5,\"t\":[1,2,3],\"matrix\":[[0,-1,0],[1,0,0],[0,0,1]]}\n", "JSON lines", true},
      {"{\"t\":[1,2,3],\"axis\":[0,0,2],\"angle\":1.5707963267948966}\n", "JSON lines", false},
  };
  for (const auto& log : logs) {
    const PoseLog read = Read(log.text);
    ASSERT_EQ(read.poses.size(), 1U) << log.text;
    EXPECT_EQ(read.has_times, log.timed) << log.text;
    EXPECT_EQ(read.description.find(log.description), 0U) << log.text;
    ExpectPose(read.poses[0], log.timed ? 2.5 : 0, {1, 2, 3}, {h, 0, 0, h});
  }
}

TEST(PoseLog, UnitsAndTheScalarsPlaceAreAsStated) {
  const double h = std::sqrt(0.5);
  ExpectPose(Read("1000 2000 3000 0 0 1 1\n", {cad::LengthUnit::kMillimetre}).poses[0], 0, {1, 2, 3},
             {h, 0, 0, h});
  ExpectPose(Read("1 2 3 1 0 0 1\n", {std::nullopt, true}).poses[0], 0, {1, 2, 3}, {h, 0, 0, h});
  // Names of columns say more than an option for logs without names.
  ExpectPose(Read("x y z qx qy qz qw\n1 2 3 0 0 1 1\n", {std::nullopt, true}).poses[0], 0, {1, 2, 3},
             {h, 0, 0, h});
  EXPECT_THROW(Read("x [mm],y [mm],z [mm],qx,qy,qz,qw\n1,2,3,0,0,1,1\n", {cad::LengthUnit::kMetre}),
               InputError);
}

TEST(PoseLog, CommentsAndBlankLinesAreNoPosesButCountAsLines) {
  const PoseLog log = Read("# a\n\n1 2 3 0 0 0 1\n# b\n4 5 6 0 0 0 1\n\n");
  ASSERT_EQ(log.poses.size(), 2U);
  EXPECT_EQ(log.poses[0].line, 3U);
  EXPECT_EQ(log.poses[1].line, 5U);
}

TEST(PoseLog, QuaternionsOfAnyLengthAreTheRotationsTheyNameAndAreNoted) {
  EXPECT_TRUE(Read("0 0 0 0 0 0 1.0001\n").notes.empty());
  for (const char* text : {"0 0 0 0 0 1e200 1e200\n", "0 0 0 0 0 1e-200 1e-200\n", "0 0 0 0 0 -3 -3\n"}) {
    const PoseLog log = Read(text);
    ExpectPose(log.poses[0], 0, {0, 0, 0}, {std::sqrt(0.5), 0, 0, std::sqrt(0.5)});
    ASSERT_EQ(log.notes.size(), 1U) << text;
    EXPECT_NE(log.notes[0].find("quaternions of lengths from"), std::string::npos);
  }
}

TEST(PoseLog, EqualTimesPassBackwardOnesDoNot) {
  EXPECT_EQ(Read("1 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n").poses.size(), 2U);
  EXPECT_THROW(Read("1 0 0 0 0 0 0 1\n0.9 0 0 0 0 0 0 1\n"), InputError);
}

// Round trip: what is written with 17 digits is read back, TUM and KITTI alike.
RC_GTEST_PROP(PoseLog, AWrittenPoseIsReadBack, ()) {
  std::array<double, 8> n{};
  for (double& value : n) value = *rc::gen::inRange(-1000, 1000) / 64.0;
  RC_PRE(n[4] != 0 || n[5] != 0 || n[6] != 0 || n[7] != 0);
  std::ostringstream tum, kitti;
  tum.precision(17);
  kitti.precision(17);
  for (const double value : n) tum << value << " ";
  double length = std::hypot(std::hypot(n[4], n[5], n[6]), n[7]);
  const double x = n[4] / length, y = n[5] / length, z = n[6] / length, w = n[7] / length;
  kitti << 1 - 2 * (y * y + z * z) << " " << 2 * (x * y - w * z) << " " << 2 * (x * z + w * y) << " " << n[1]
        << " " << 2 * (x * y + w * z) << " " << 1 - 2 * (x * x + z * z) << " " << 2 * (y * z - w * x) << " "
        << n[2] << " " << 2 * (x * z - w * y) << " " << 2 * (y * z + w * x) << " " << 1 - 2 * (x * x + y * y)
        << " " << n[3];
  const LoggedPose a = Read(tum.str()).poses.at(0), b = Read(kitti.str()).poses.at(0);
  ExpectPose(a, n[0], {n[1], n[2], n[3]}, {w, x, y, z});
  ExpectPose(b, 0, {n[1], n[2], n[3]}, {w, x, y, z});
}

// A million poses are read one after the other; here ten thousand, in the memory of a line.
TEST(PoseLog, AStreamGivesPoseAfterPose) {
  std::string text;
  for (int i = 0; i < 10000; ++i) text += std::to_string(i) + " 1 2 3 0 0 0 1\n";
  std::istringstream in(text);
  PoseLogStream stream(in, "log");
  int count = 0;
  while (const auto pose = stream.Next()) EXPECT_EQ(pose->time, count++);
  EXPECT_EQ(count, 10000);
}

}  // namespace
}  // namespace tact::input
