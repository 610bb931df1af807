/// @file
/// The trajectory between two contact relations as a non-linear programme, by Ipopt.
/// Model   Knots q_0 ... q_K, q_0 the given start. Equalities: the gaps of C_s at q_1 ... q_{K-1}, of C_e at q_K (of both as
///         many as are independent there), unit quaternions. Inequalities: gaps of vertices over faces and of C_e's
///         contacts, where the guess has them open and near, at the knots between. Objective: rotation first, the
///         sum of squared quaternion steps; then translation with the orientations kept, the sum of squared
///         steps. Both are the squared length of the path where steps are equal, as in the optimum.
///         By the thesis' definition: moreover no turn about A_e (A.19), and where nothing turns no translation along
///         T_e (A.10). Both are linear in the knots.
/// Method  Exact first and second derivatives (knot_jet.h); Ipopt with MUMPS.
/// Exact   no. What comes out is a local optimum; feasibility and stationarity are reported, overlap by exact geometry.
/// Departs Only contacts near the guess are watched: a solved path may overlap, and its status says so. Orientations that are optimal in
///         the first solve are not exchanged for others as good in the second.
#pragma once

#include <string>
#include <vector>

#include "robot/planning/trajectory_check.h"

namespace tact::planning {

enum class PathDefinition { kLeast, kThesis };

struct IpoptPlan {
  bool solved = false;
  std::string status;                   // Ipopt's, in words
  std::vector<joint::Transform> knots;  // from the start to the end
  double angle = 0, distance = 0;       // of the whole path, knot by knot
  double violation = 0;     // the largest |gap| of the relations that should hold, in the solids' unit
  double stationarity = 0;  // Ipopt's dual infeasibility, the larger of both solves
  double overlap = 0;       // of the solids at a knot
  double apart = 0;         // from the closed form: see DistanceBetween; 0 without it
  int iterations = 0;       // of both solves
};

/// The closed form's trajectory is the guess and says in which direction to plan; where it failed, the guess is the
/// interpolation of the given poses.
IpoptPlan PlanByIpopt(const SolidPair& solids, const ContactState& start, const ContactState& end,
                      const Trajectory& closed_form, PathDefinition definition, int knots = 20);

/// The farthest that a pose of one path is from all of the other's: the root of the squared distance of locations and
/// the squared angle times the size.
double DistanceBetween(const std::vector<joint::Transform>& path, const std::vector<Sample>& other,
                       double size);

}  // namespace tact::planning
