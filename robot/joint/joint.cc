#include "robot/joint/joint.h"

#include <cmath>

namespace tact::joint {
namespace {

Eigen::Matrix3d RotationZ(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}
Eigen::Matrix3d RotationY(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()).toRotationMatrix();
}

// The angle whose Rz is nearest to R in the sum of squares.
double AngleAboutZ(const Eigen::Matrix3d& R) { return std::atan2(R(1, 0) - R(0, 1), R(0, 0) + R(1, 1)); }
double AngleAboutY(const Eigen::Matrix3d& R) { return std::atan2(R(0, 2) - R(2, 0), R(0, 0) + R(2, 2)); }

struct TypeRow {
  std::string_view name;
  int dof;
  int angles;  // unbounded ones
};
constexpr std::array<TypeRow, kJointTypes.size()> kRows = {{{"rigid", 0, 0},
                                                            {"prismatic", 1, 0},
                                                            {"revolute", 1, 1},
                                                            {"screw", 1, 1},
                                                            {"cylindrical", 2, 1},
                                                            {"spherical", 3, 0},
                                                            {"planar", 3, 1},
                                                            {"two-axis", 2, 2}}};

}  // namespace

std::string_view NameOf(JointType type) { return kRows[static_cast<std::size_t>(type)].name; }
int JointDof(JointType type) { return kRows[static_cast<std::size_t>(type)].dof; }
int UnboundedAngles(JointType type) { return kRows[static_cast<std::size_t>(type)].angles; }

Transform MotionOf(const Joint& joint, const Coordinates& q) {
  using Eigen::Vector3d;
  switch (joint.type) {
    case JointType::kRigid:
      return {};
    case JointType::kPrismatic:
      return {Eigen::Matrix3d::Identity(), Vector3d(0, 0, q[0])};
    case JointType::kRevolute:
      return {RotationZ(q[0]), Vector3d::Zero()};
    case JointType::kScrew:
      return {RotationZ(q[0]), Vector3d(0, 0, joint.pitch * q[0])};
    case JointType::kCylindrical:
      return {RotationZ(q[0]), Vector3d(0, 0, q[1])};
    case JointType::kSpherical:
      return {RotationExp(q), Vector3d::Zero()};
    case JointType::kPlanar:
      return {RotationZ(q[0]), Vector3d(q[1], q[2], 0)};
    case JointType::kTwoAxis: {
      const Eigen::Matrix3d first = RotationZ(q[0]);
      return {first * RotationY(q[1]), joint.offset * first.col(0)};
    }
  }
  return {};
}

Coordinates CoordinatesNear(const Joint& joint, const Transform& X_BA) {
  const Transform M = joint.X_BJ.Inverse() * X_BA * joint.X_AJ;
  switch (joint.type) {
    case JointType::kRigid:
      return {0, 0, 0};
    case JointType::kPrismatic:
      return {M.p.z(), 0, 0};
    case JointType::kRevolute:
    case JointType::kScrew:
      return {AngleAboutZ(M.R), 0, 0};
    case JointType::kCylindrical:
      return {AngleAboutZ(M.R), M.p.z(), 0};
    case JointType::kSpherical:
      return RotationLog(M.R);
    case JointType::kPlanar:
      return {AngleAboutZ(M.R), M.p.x(), M.p.y()};
    case JointType::kTwoAxis: {
      const double first = std::atan2(-M.R(0, 1), M.R(1, 1));
      return {first, AngleAboutY(RotationZ(-first) * M.R), 0};
    }
  }
  return {0, 0, 0};
}

}  // namespace tact::joint
