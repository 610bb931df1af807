#include "robot/planning/demonstration_plan.h"

#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"

namespace tact::planning {
namespace {

PlannedState StateOf(const recognition::ModelPair& models, const input::NamedPose& named) {
  const algebra::Pose& pose = named.pose.pose;
  auto found = ContactsInPose(models, pose, named.where + " (state " + named.name + ")");
  const algebra::MotionDof dof = ComputeMotionDof(found.relation);
  // Normals are compared with those of the moving solid's faces, so it has to be where it is.
  Relation relation =
      recognition::PointContactsOf(found, algebra::Transform(models.moving, pose), models.fixed);
  return {named.name,
          {std::move(relation), joint::ToTransform(pose),
           Ranks{dof.translation.restricted, dof.rotation.restricted}},
          std::move(found.relation)};
}

}  // namespace

DemonstrationStates StatesOf(const recognition::ModelPair& models,
                             const std::vector<input::NamedPose>& states) {
  DemonstrationStates answer{MakeSolidPair(models.moving, models.fixed), models.unit, {}, models.notes};
  for (const input::NamedPose& state : states) {
    answer.states.push_back(StateOf(models, state));
    if (!state.pose.exact)
      answer.notes.push_back("state " + state.name +
                             ": its rotation was rounded to a rational one, so contacts may be missed");
  }
  return answer;
}

DemonstrationStates StatesOf(const input::Demonstration& demonstration, const std::string& source) {
  const auto* poses = std::get_if<input::PoseDemonstration>(&demonstration);
  if (poses == nullptr)
    throw InputError(source +
                     ": expected two models and the poses of the moving one, got contact relations, " +
                     "which do not say where the solids are");
  if (poses->states.size() < 2)
    throw InputError(source + ": expected two states or more, got " + std::to_string(poses->states.size()) +
                     ": there is no transition to plan");
  if (poses->models.tolerance.sign() != 0)
    throw InputError(source + ": expected \"tolerance\":0, got " + poses->models.tolerance.ToDecimal() +
                     ": a trajectory maintains contacts that hold exactly; correct the poses first");
  return StatesOf(recognition::LoadModels(poses->models), poses->states);
}

PlannedTransition PlanTransition(const DemonstrationStates& states, size_t from, size_t to, int steps) {
  const ContactState &start = states.states.at(from).state, &end = states.states.at(to).state;
  PlannedTransition planned{from, to, PlanOptimalTrajectory(states.solids, start, end, steps), {}};
  planned.check = CheckTrajectory(states.solids, start, end, planned.trajectory);
  return planned;
}

}  // namespace tact::planning
