#include "robot/joint/joint_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

TEST(JointSelection, NamesWhatMadeThePoses) {
  for (const NoiseLaw law : {NoiseLaw::kGaussian, NoiseLaw::kRectangular}) {
    Simulation simulation(20);
    for (const JointType type : kJointTypes) {
      const auto poses = simulation.Poses(simulation.AnyJoint(type, 0.3), 100, law);
      const JointSelection selection = SelectJoint(poses);
      ASSERT_TRUE(selection.type.has_value()) << NameOf(type) << ": " << selection.reason;
      EXPECT_EQ(NameOf(*selection.type), NameOf(type)) << selection.reason;
    }
  }
}

TEST(JointSelection, CannotTellFromFewPosesOrFromOne) {
  Simulation simulation(21);
  const auto poses = simulation.Poses(simulation.AnyJoint(JointType::kRevolute), 30, NoiseLaw::kGaussian);
  for (const std::size_t count : {1u, 2u, 4u}) {
    const JointSelection selection = SelectJoint(std::span(poses).first(count));
    EXPECT_FALSE(selection.type.has_value());
    EXPECT_NE(selection.reason.find("too few poses"), std::string::npos);
  }
  const JointSelection same = SelectJoint(std::vector<Transform>(30, poses.front()));
  EXPECT_FALSE(same.type.has_value());
  EXPECT_EQ(same.reason, "all poses are the same one");
}

TEST(JointSelection, WithoutMotionIsRigidAndSaysSo) {
  Simulation simulation(22);
  const JointSelection selection =
      SelectJoint(simulation.Poses(simulation.AnyJoint(JointType::kRigid), 60, NoiseLaw::kGaussian));
  EXPECT_EQ(selection.type, JointType::kRigid);
  EXPECT_NE(selection.reason.find("no motion"), std::string::npos);
}

// Half a degree about an axis 0.3 m away moves 3 mm, the noise's scale: never called more than it shows.
TEST(JointSelection, ASmallArcIsNotCalledAnythingItIsNot) {
  Simulation simulation(23);
  for (int trial = 0; trial < 5; ++trial) {
    const Joint truth = simulation.AnyJoint(JointType::kRevolute, 0.3);
    std::vector<Transform> poses;
    for (int i = 0; i < 60; ++i) {
      poses.push_back(simulation.Noisy(PoseAt(truth, {0.5 * kDegree * i / 60, 0, 0}), NoiseLaw::kGaussian));
    }
    const JointSelection selection = SelectJoint(poses);
    EXPECT_TRUE(!selection.type || Generalises(JointType::kRevolute, *selection.type))
        << NameOf(*selection.type);
  }
}

TEST(JointSelection, SurvivesWrongPoses) {
  Simulation simulation(24);
  for (const JointType type : {JointType::kPrismatic, JointType::kRevolute, JointType::kScrew}) {
    auto poses = simulation.Poses(simulation.AnyJoint(type, 0.3), 120, NoiseLaw::kGaussian);
    for (std::size_t i = 2; i < poses.size(); i += 5) poses[i] = simulation.Frame(0.5);
    const JointSelection selection = SelectJoint(poses);
    ASSERT_TRUE(selection.type.has_value()) << selection.reason;
    EXPECT_EQ(NameOf(*selection.type), NameOf(type));
  }
}

// Recorded doors and drawers, one pose a line: x y z qx qy qz qw. Which is which is seen from the fitted motion: a door's
// handle turns by most of a radian, a drawer's by no more than a tracker bends.
std::vector<Transform> Recording(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<Transform> poses;
  double x, y, z, qx, qy, qz, qw;
  while (file >> x >> y >> z >> qx >> qy >> qz >> qw) {
    poses.push_back({Eigen::Quaterniond(qw, qx, qy, qz).normalized().toRotationMatrix(), {x, y, z}});
  }
  return poses;
}

TEST(JointSelection, NamesRecordedDoorsAndDrawersAndPredictsThem) {
  const std::filesystem::path folder = std::string(TACT_SOURCE_DIR) + "/../shared/data/kitchen";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no shared data here";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".log") continue;
    const std::vector<Transform> poses = Recording(entry.path());
    double turn = 0;
    for (const Transform& X : poses)
      turn = std::max(turn, RotationLog(X.R * poses.front().R.transpose()).norm());
    const JointType right = turn > 0.5 ? JointType::kRevolute : JointType::kPrismatic;
    const JointSelection selection = SelectJoint(poses);
    ASSERT_TRUE(selection.type.has_value()) << entry.path() << selection.reason;
    EXPECT_EQ(NameOf(*selection.type), NameOf(right)) << entry.path();
    // Every third block of ten poses held back: the joint of the others passes within the tracker's bending of them.
    std::vector<Transform> seen, held;
    for (std::size_t i = 0; i < poses.size(); ++i) (i / 10 % 3 == 2 ? held : seen).push_back(poses[i]);
    const Joint joint = FitRobustly(right, seen, {1, 50, {0.02, 0.003}}).fit.joint;
    std::vector<double> errors;
    for (const Transform& X : held)
      errors.push_back((PoseAt(joint, CoordinatesNear(joint, X)).p - X.p).norm());
    std::nth_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                     errors.end());
    EXPECT_LT(errors[errors.size() / 2], 0.02) << entry.path();
  }
}

TEST(JointSelection, GeneralTypesContainSpecialOnes) {
  for (const JointType a : kJointTypes) {
    EXPECT_TRUE(Generalises(a, a));
    EXPECT_TRUE(Generalises(a, JointType::kRigid));
    for (const JointType b : kJointTypes) {
      EXPECT_TRUE(a == b || !Generalises(a, b) || !Generalises(b, a)) << NameOf(a) << ' ' << NameOf(b);
      EXPECT_TRUE(!Generalises(a, b) || JointDof(b) <= JointDof(a));
      for (const JointType c : kJointTypes) {
        EXPECT_TRUE(!Generalises(a, b) || !Generalises(b, c) || Generalises(a, c));
      }
    }
  }
}

}  // namespace
}  // namespace tact::joint
