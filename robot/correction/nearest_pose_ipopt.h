/// @file
/// The nearest pose that satisfies a relation without penetration, by Ipopt: the reference for nearest_pose.h.
/// Model   The same distance and the same contacts; the pose is a unit quaternion and the reference point's place. What
///         keeps two convex pieces apart is no choice among planes here but a plane of its own, four more variables, with
///         all corners of one piece on one side and all of the other's on the other. Every function is a polynomial but the
///         distance; Hessians are exact (jet.h).
/// Method  Interior points [Waechter and Biegler 2006], from one start: a local optimum.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame.
/// Units   the solids' length; inside, all lengths are over the models' size.
#pragma once

#include "robot/correction/nearest_pose.h"

namespace tact::correction {

struct IpoptAnswer {
  joint::Transform X_FM;
  Outcome outcome = Outcome::kNotConverged;  // judged as every answer is
  double distance = 0;
  bool optimal = false;  // Ipopt found its conditions of optimality met
  int iterations = 0;
  double infeasibility = 0, stationarity = 0;  // what Ipopt says is left of both
};

/// Pre: the relation has a realisation.
IpoptAnswer NearestPoseByIpopt(const Models& models, const Relation& relation, const joint::Transform& X0,
                               const joint::Transform& start, const Metric& metric = {});

}  // namespace tact::correction
