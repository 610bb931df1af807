#include "robot/joint/joint_jacobian.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "robot/joint/joint_gauge.h"
#include "robot/joint/simulated_joint.h"

namespace tact::joint {
namespace {

JointType AnyType() { return kJointTypes[*rc::gen::inRange<std::size_t>(0, kJointTypes.size())]; }
Simulation AnySimulation() { return Simulation(*rc::gen::inRange<unsigned>(0, 1000000)); }

Vector6 Between(const Joint& joint, const Transform& from, const Transform& to) {
  Vector6 difference;
  const Eigen::Matrix3d R_JB = joint.X_BJ.R.transpose();
  difference << R_JB * RotationLog(to.R * from.R.transpose()), R_JB * (to.p - from.p);
  return difference;
}

double Distance(const Transform& a, const Transform& b) { return (a.R - b.R).norm() + (a.p - b.p).norm(); }

RC_GTEST_PROP(JointJacobian, IsTheLimitOfDifferences, ()) {
  constexpr double kStep = 1e-5;
  Simulation simulation = AnySimulation();
  const Joint joint = simulation.AnyJoint(AnyType());
  const Coordinates q = simulation.AnyCoordinates(joint.type, 0.3);
  const JointJacobian jacobian = JacobianAt(joint, q);
  RC_ASSERT(jacobian.parameters.cols() == JointParameters(joint.type));
  RC_ASSERT(jacobian.coordinates.cols() == JointDof(joint.type));
  const Transform X = PoseAt(joint, q);
  for (int i = 0; i < JointParameters(joint.type); ++i) {
    const ParameterVector step = kStep * ParameterVector::Unit(JointParameters(joint.type), i);
    const Vector6 slope = Between(joint, X, PoseAt(Changed(joint, step), q)) -
                          Between(joint, X, PoseAt(Changed(joint, -step), q));
    RC_ASSERT((slope / (2 * kStep) - jacobian.parameters.col(i)).norm() < 1e-7);
  }
  for (int i = 0; i < JointDof(joint.type); ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const Vector6 slope = Between(joint, X, PoseAt(joint, Changed(joint, q, step))) -
                          Between(joint, X, PoseAt(joint, Changed(joint, q, -step)));
    RC_ASSERT((slope / (2 * kStep) - jacobian.coordinates.col(i)).norm() < 1e-7);
  }
}

RC_GTEST_PROP(Joint, CoordinatesOfAnAllowedPoseGiveThatPose, ()) {
  Simulation simulation = AnySimulation();
  const Joint joint = simulation.AnyJoint(AnyType());
  const Transform X = PoseAt(joint, simulation.AnyCoordinates(joint.type, simulation.Uniform(-1, 1)));
  RC_ASSERT(Distance(X, PoseAt(joint, CoordinatesNear(joint, X))) < 1e-12);
}

RC_GTEST_PROP(JointGauge, KeepsTheSetOfPoses, ()) {
  Simulation simulation = AnySimulation();
  const Joint joint = simulation.AnyJoint(AnyType());
  const Coordinates zero = simulation.AnyCoordinates(joint.type, 0.7);
  const Transform X = PoseAt(joint, simulation.AnyCoordinates(joint.type, 0.4));
  for (const Joint& same :
       {ZeroedAt(joint, zero), Reversed(joint), OffsetReversed(joint), AlignedWith(joint, Reversed(joint))}) {
    RC_ASSERT(Distance(X, PoseAt(same, CoordinatesNear(same, X))) < 1e-12);
  }
  RC_ASSERT(Distance(PoseAt(joint, zero), PoseAt(ZeroedAt(joint, zero), {0, 0, 0})) < 1e-12);
}

TEST(JointGauge, NormalFormRisesFromZero) {
  Simulation simulation(1);
  for (const JointType type : kJointTypes) {
    if (JointDof(type) == 0 || type == JointType::kSpherical) continue;
    const Joint joint = simulation.AnyJoint(type);
    const auto poses = simulation.Poses(joint, 20, NoiseLaw::kNone);
    const Joint normal = InNormalForm(Reversed(joint), poses);
    EXPECT_LT(CoordinatesNear(normal, poses.front()).norm(), 1e-12) << NameOf(type);
    if (JointDof(type) == 1) {
      EXPECT_GT(CoordinatesNear(normal, poses.back())[0], 0) << NameOf(type);
    }
    EXPECT_GE(normal.offset, 0);
  }
}

}  // namespace
}  // namespace tact::joint
