/// @file
/// A path over knots as a non-linear programme, and Ipopt's solution of it.
/// Model   unknowns: of each knot after the first a quaternion and a location, in units of the moving solid's size. Equalities:
///         the contacts' gaps, unit quaternions, linear ones; inequalities: gaps that stay open. Objective: the sum of
///         squared quaternion steps in the first stage, of squared ways in the second, whose quaternions are fixed.
/// Exact   no; derivatives are exact to second order (knot_jet.h).
#pragma once

#include <string>
#include <vector>

#include "robot/planning/optimal_trajectory.h"

namespace tact::planning {

inline constexpr int kNumbers = 7;  // of a knot: w x y z of the quaternion, the location over the size

enum class Stage { kRotation, kTranslation };

struct Linear {  // of one knot: coefficients . numbers = value
  Eigen::Matrix<double, 7, 1> coefficients;
  double value = 0;
};

struct KnotConstraints {
  Relation equal, open;
  std::vector<Linear> linear;
};

struct Programme {
  const SolidPair& solids;
  Eigen::Matrix<double, 7, 1> first;   // q_0
  std::vector<KnotConstraints> knots;  // of q_1 ... q_K
  std::vector<double> guess;           // their numbers
};

struct ProgrammeAnswer {
  bool solved = false;
  std::string status;       // Ipopt's, in words
  double stationarity = 0;  // Ipopt's dual infeasibility
  int iterations = 0;
  std::vector<double> numbers;  // of the knots; empty if Ipopt gave none
};

ProgrammeAnswer SolveByIpopt(const Programme& programme, Stage stage);

}  // namespace tact::planning
