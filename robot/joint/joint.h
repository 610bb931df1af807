/// @file
/// Joints: the poses of a link A in a link B that a joint allows.
/// Model   X_BA = X_BJ M(q) X_AJ^-1: the joint's frame as fixed in B, its motion, the joint's frame as fixed in A.
///           rigid        M = I
///           prismatic    M = T(0, 0, q1)                                  thesis 4.2
///           revolute     M = Rz(q1)                                       thesis 4.3
///           screw        M = Rz(q1) T(0, 0, pitch q1)                     thesis 4.4
///           cylindrical  M = Rz(q1) T(0, 0, q2)
///           spherical    M = rotation by the rotation vector q
///           planar       M = T(q2, q3, 0) Rz(q1)
///           two-axis     M = Rz(q1) T(offset, 0, 0) Ry(q2)                thesis 4.6, the axes offset apart
/// Frames  the axis (line, plane's normal) is J's z; two-axis: z in B and y in A.
/// Units   metre, radian; pitch in metre a radian.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "robot/joint/transform.h"

namespace tact::joint {

enum class JointType : std::uint8_t {
  kRigid,
  kPrismatic,
  kRevolute,
  kScrew,
  kCylindrical,
  kSpherical,
  kPlanar,
  kTwoAxis
};

inline constexpr std::array kJointTypes = {JointType::kRigid,  JointType::kPrismatic,   JointType::kRevolute,
                                           JointType::kScrew,  JointType::kCylindrical, JointType::kSpherical,
                                           JointType::kPlanar, JointType::kTwoAxis};

std::string_view NameOf(JointType type);

/// q: the first JointDof(type) entries count.
using Coordinates = Eigen::Vector3d;

/// How many coordinates move the joint.
int JointDof(JointType type);

/// How many of the first coordinates are angles that may go past pi.
int UnboundedAngles(JointType type);

struct Joint {
  JointType type = JointType::kRigid;
  Transform X_BJ, X_AJ;
  double pitch = 0;   // screw only
  double offset = 0;  // two-axis only
};

/// M(q).
Transform MotionOf(const Joint& joint, const Coordinates& q);

/// X_BA at q.
inline Transform PoseAt(const Joint& joint, const Coordinates& q) {
  return joint.X_BJ * MotionOf(joint, q) * joint.X_AJ.Inverse();
}

/// Coordinates at which the joint comes near the pose X_BA; exact for a pose that the joint allows. Angles lie in
/// [-pi, pi].
Coordinates CoordinatesNear(const Joint& joint, const Transform& X_BA);

}  // namespace tact::joint
