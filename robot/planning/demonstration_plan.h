/// @file
/// Every transition between neighbouring states of a demonstration, planned [thesis, A.5, A.6.3].
/// Exact   contacts and restricted DOFs, by the exact engine; trajectories are double.
/// Errors  InputError: relations without poses, fewer than two states, a tolerance other than zero (contacts that hold only
///         nearly leave nothing to maintain), and what posed_models.h refuses.
#pragma once

#include "robot/input/demonstration.h"
#include "robot/planning/trajectory_check.h"
#include "robot/recognition/posed_models.h"

namespace tact::planning {

struct PlannedState {
  std::string name;
  ContactState state;
  algebra::ContactRelation relation;
};

struct DemonstrationStates {
  SolidPair solids;
  cad::LengthUnit unit = cad::LengthUnit::kMillimetre;
  std::vector<PlannedState> states;
  std::vector<std::string> notes;
};

/// source names the demonstration in errors.
DemonstrationStates StatesOf(const input::Demonstration& demonstration, const std::string& source);
/// The same with models already loaded.
DemonstrationStates StatesOf(const recognition::ModelPair& models,
                             const std::vector<input::NamedPose>& states);

struct PlannedTransition {
  size_t from = 0, to = 0;  // states, from 0
  Trajectory trajectory;
  TrajectoryCheck check;
  /// Of the trajectory, else of its check; "" if it can be followed.
  const std::string& failure() const {
    return trajectory.failure.empty() ? check.failure : trajectory.failure;
  }
};

/// steps: samples a segment.
PlannedTransition PlanTransition(const DemonstrationStates& states, size_t from, size_t to, int steps);

}  // namespace tact::planning
