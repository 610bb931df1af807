/// @file
/// The contact relations that a pose with errors may be one of, each with the nearest pose that has it.
/// Model   The pose's errors are Gaussian: `noise.rotation` (radian) and `noise.location` a component, rotations about the
///         middle of the moving solid. From no contact on, a relation grows by one near contact at a time: the least change
///         in units of the noise that closes its gaps (Gauss-Newton by steps of least norm [thesis, 2.7.3]), and then every
///         near contact whose gap is closed there belongs to it. The cost is half the change's square minus `reward` for
///         each DOF of configuration that the relation takes away: the logarithm of how much narrower the noise is than
///         the range in which a pose without contact might as well be. The best kGrown of each size grow on; where another
///         near contact's gap became negative, by one of these, for at the nearest pose that does not penetrate one of
///         them is closed.
/// Frames  the fixed solid's, F; X_FM is the moving solid's pose in it.
/// Exact   no: `contacts` close at X_FM to kClosed.
/// Cost    kGrown times the near contacts, six times over: some ten milliseconds.
#pragma once

#include <vector>

#include "robot/recognition/near_contacts.h"

namespace tact::recognition {

struct PoseNoise {
  double rotation = 0;  // radian, standard deviation of a component
  double location = 0;  // the solids' unit
};

inline constexpr size_t kGrown = 12;
inline constexpr double kClosed = 1e-6;  // of the solids' unit: doubles leave less, no noise is so small

struct RelationCandidate {
  std::vector<PointContact> contacts;  // sorted
  joint::Transform X_FM;
  Eigen::Matrix<double, 6, 1> change;  // the pose given to X_FM, in units of the noise: [rotation; location]
  int taken = 0;                       // DOFs of configuration, the rank of the contacts' rows
  Eigen::Vector2d share;  // of them that rotation and location have in the change, in units of the noise
  double cost = 0;
};

struct CandidateSearch {
  PoseNoise noise;
  double reward = 3;      // nat a DOF
  double deviations = 4;  // a contact may be so many standard deviations away
};

/// Best first. No near contact penetrates at a candidate's pose; whether the solids do is for the caller to find out.
/// The empty relation is always among them, wherever the pose given is.
std::vector<RelationCandidate> FindRelationCandidates(const ProximitySolid& moving,
                                                      const ProximitySolid& fixed,
                                                      const joint::Transform& X_FM,
                                                      const CandidateSearch& search);

}  // namespace tact::recognition
