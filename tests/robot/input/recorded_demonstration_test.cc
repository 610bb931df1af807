#include "robot/input/recorded_demonstration.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "algebra/error.h"

namespace tact::input {
namespace {

using joint::Transform;

RecordedDemonstration Read(const std::string& text, const std::string& source = "folder/recording",
                           const RecordingOptions& options = {}) {
  std::istringstream in(text);
  return ReadRecording(in, source, options);
}

void ExpectSame(const Transform& a, const Transform& b, double tolerance) {
  EXPECT_LT((a.R - b.R).norm(), tolerance) << a.R << "\n" << b.R;
  EXPECT_LT((a.p - b.p).norm(), tolerance) << a.p << "\n" << b.p;
}

// By hand: F turned by a quarter about z at (10, 0, 0), M at (10, 5, 2) with the same orientation: in F, y is -x... so
// M - F = (0, 5, 2) has the coordinates (5, 0, 2).
const char kList[] =
    "No of Models: 2\n.\\peg.step\nparts\\hole.off\n\nNo of Scenes: 2\n"
    "2 10 5 2  0 0 1 1.5707963267948966\n0 10 0 0  0 0 1 1.5707963267948966\n\n"
    "2 1 2 3  0 0 0 0\n0 1 2 3  1 0 0 3.141592653589793\n";

TEST(RecordedDemonstration, APoseListIsTheMovingObjectInTheFixedOnesFrame) {
  const RecordedDemonstration recording = Read(kList);
  EXPECT_EQ(recording.models.moving, "folder/peg.step");
  EXPECT_EQ(recording.models.fixed, "folder/parts/hole.off");
  EXPECT_EQ(recording.models.unit, cad::LengthUnit::kMillimetre);
  ASSERT_EQ(recording.scenes.size(), 2U);
  ExpectSame(recording.scenes[0].X_FM, {Eigen::Matrix3d::Identity(), {5, 0, 2}}, 1e-12);
  ExpectSame(recording.scenes[1].X_FM,
             {Eigen::Vector3d(1, -1, -1).asDiagonal().toDenseMatrix(), Eigen::Vector3d::Zero()}, 1e-12);
  EXPECT_EQ(recording.scenes[1].name, "2");
  EXPECT_EQ(recording.scenes[1].where, "folder/recording:9:1");
  ASSERT_TRUE(recording.scenes[0].X_CF);
  EXPECT_EQ(recording.scenes[0].X_CF->p, Eigen::Vector3d(10, 0, 0));
  EXPECT_FALSE(recording.scenes[0].exact);
  EXPECT_EQ(Read(kList, "x", {cad::LengthUnit::kMetre}).models.unit, cad::LengthUnit::kMetre);
}

TEST(RecordedDemonstration, OurDemonstrationKeepsExactPosesAndTimes) {
  const RecordedDemonstration recording =
      Read(R"({"moving":"a.off","fixed":"b.off","unit":"cm","states":[)"
           R"({"name":"A","time":2.5,"pose":{"t":[1,2,"1/3"],"q":[1,0,0,1]}},)"
           R"({"time":3,"pose":{"t":[0,0,0],"axis":[0,0,1],"angle":0.5}}]})");
  ASSERT_EQ(recording.scenes.size(), 2U);
  EXPECT_EQ(recording.scenes[0].name, "A");
  EXPECT_EQ(recording.scenes[0].time, 2.5);
  ASSERT_TRUE(recording.scenes[0].exact);
  EXPECT_EQ(recording.scenes[0].exact->translation.z, algebra::Rational(1) / 3);
  ExpectSame(recording.scenes[0].X_FM,
             {Eigen::AngleAxisd(M_PI / 2, Eigen::Vector3d::UnitZ()).toRotationMatrix(), {1, 2, 1.0 / 3}},
             1e-12);
  EXPECT_FALSE(recording.scenes[1].exact);
  EXPECT_EQ(recording.models.unit, cad::LengthUnit::kCentimetre);
}

class Logs : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / "tact_recorded_logs";
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  std::filesystem::path folder_;
};

// The list's two scenes as TUM logs in metre, and once more as the relative poses.
TEST_F(Logs, TwoLogsAreTheSameRecordingAsTheList) {
  Write("peg.txt",
        "0.0 0.010 0.005 0.002 0 0 0.7071067811865476 0.7071067811865476\n"
        "1.0 0.001 0.002 0.003 0 0 0 1\n2.0 9 9 9 0 0 0 1\n");
  Write("hole.txt",
        "0.01 0.010 0 0 0 0 0.7071067811865476 0.7071067811865476\n1.01 0.001 0.002 0.003 1 0 0 0\n");
  Write("relative.txt", "5 0 2 1 0 0 0\n0 0 0 0 1 0 0\n");
  Write("two.json", R"({"moving":"peg.step","fixed":"parts/hole.off","unit":"mm",)"
                    R"("logs":{"moving":"peg.txt","fixed":"hole.txt","unit":"m","time_limit":0.1}})");
  Write("one.json", R"({"moving":"peg.step","fixed":"parts/hole.off","unit":"mm",)"
                    R"("logs":{"relative":"relative.txt","unit":"mm","quaternion":"wxyz"}})");
  const RecordedDemonstration list = Read(kList);
  for (const std::string name : {"two.json", "one.json"}) {
    const RecordedDemonstration recording = ReadRecording((folder_ / name).string());
    EXPECT_EQ(recording.models.fixed, folder_ / "parts/hole.off");
    ASSERT_EQ(recording.scenes.size(), 2U) << name;
    for (size_t i = 0; i < 2; ++i) ExpectSame(recording.scenes[i].X_FM, list.scenes[i].X_FM, 1e-9);
    EXPECT_EQ(recording.scenes[0].X_CF.has_value(), name == "two.json");
    EXPECT_EQ(recording.scenes[1].time.has_value(), name == "two.json");
    EXPECT_FALSE(recording.notes.empty() &&
                 name == "two.json");  // how they were matched, and what was left out
  }
}

RC_GTEST_PROP(RecordedDemonstration, WrittenAsJsonItReadsBackTheSame, ()) {
  RecordedDemonstration recording;
  recording.models = {"folder/a \"b\".off", "c\\d.off", cad::LengthUnit::kInch, algebra::Rational(1) / 3};
  const auto number = [] { return *rc::gen::inRange(-100000, 100000) / 977.0; };
  const size_t count = *rc::gen::inRange<size_t>(1, 4);
  const bool timed = *rc::gen::arbitrary<bool>();
  for (size_t i = 0; i < count; ++i) {
    RecordedScene scene;
    scene.name = "scene " + std::to_string(i);
    if (timed) scene.time = static_cast<double>(i) / 7;
    scene.X_FM = {joint::RotationExp({number(), number(), number()}), {number(), number(), number()}};
    recording.scenes.push_back(scene);
  }
  const RecordedDemonstration back = Read(ToDemonstrationJson(recording, "folder"), "folder/demo.json");
  RC_ASSERT(back.models.moving.lexically_normal() == recording.models.moving);
  RC_ASSERT(back.models.tolerance == recording.models.tolerance);
  RC_ASSERT(back.scenes.size() == count);
  for (size_t i = 0; i < count; ++i) {
    RC_ASSERT(back.scenes[i].name == recording.scenes[i].name);
    RC_ASSERT(back.scenes[i].time == recording.scenes[i].time);
    RC_ASSERT((back.scenes[i].X_FM.R - recording.scenes[i].X_FM.R).norm() < 1e-12);
    RC_ASSERT((back.scenes[i].X_FM.p - recording.scenes[i].X_FM.p).norm() <
              1e-12);  // the last digit of a double
  }
}

TEST(RecordedDemonstration, ExactPosesAreWrittenExactly) {
  const std::string text =
      R"({"moving":"a.off","fixed":"b.off","unit":"mm","states":[{"name":"A","pose":{"t":["1/3",2,0],"q":[10,0,1,0]}}]})";
  const RecordedDemonstration first = Read(text, "x/a.json");
  const RecordedDemonstration again = Read(ToDemonstrationJson(first, "x"), "x/b.json");
  EXPECT_EQ(*first.scenes[0].exact, *again.scenes[0].exact);
  EXPECT_EQ(first.models.moving, again.models.moving);
}

// Its README: 41 scenes; the hole stands still.
TEST(RecordedDemonstration, ThePublishedRecordingIsRead) {
  const std::string path = std::string(TACT_SOURCE_DIR) + "/../shared/data/peg_in_hole/peg_in_hole.pose.list";
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no shared data here";
  const RecordedDemonstration recording = ReadRecording(path);
  ASSERT_EQ(recording.scenes.size(), 41U);
  EXPECT_EQ(recording.models.moving.filename(), "peg.step");
  for (const RecordedScene& scene : recording.scenes) {
    EXPECT_LT((scene.X_CF->p - recording.scenes[0].X_CF->p).norm(), 2) << scene.name;
    // What the list writes, found again: X_CM = X_CF X_FM.
    EXPECT_LT((scene.X_CF->R * scene.X_FM.p + scene.X_CF->p).norm(), 2000) << scene.name;
  }
}

}  // namespace
}  // namespace tact::input
