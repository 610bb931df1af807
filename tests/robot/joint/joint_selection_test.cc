#include "robot/joint/joint_selection.h"

#include <gtest/gtest.h>

#include "tests/robot/joint/simulated_joint.h"

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
