#include "provers/claims/vision_correction_trials.h"

#include <algorithm>
#include <map>
#include <mutex>

#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "provers/claims/joint_trials.h"
#include "robot/correction/gauss_newton.h"
#include "robot/correction/linear_correction.h"
#include "robot/correction/nearest_pose.h"
#include "robot/correction/nearest_pose_ipopt.h"
#include "robot/correction/table_relations.h"
#include "robot/perception/random_numbers.h"

namespace tact::provers {
namespace {

using CorrectionOutcome = correction::Outcome;
using joint::Transform;

Eigen::Vector3d Direction(perception::RandomNumbers& random) {
  for (;;) {
    const Eigen::Vector3d v = random.InBall();
    if (v.norm() > 1e-3) return v.normalized();
  }
}

// [thesis, eq. (4.28), (4.29)], in millimetres.
Transform Contaminated(const Transform& X, std::uint64_t seed) {
  perception::RandomNumbers random(seed);
  const Eigen::Vector3d w = kMostTurn * random.Uniform() * Direction(random);
  const Eigen::Vector3d d = kMostShift / kMillimetre * random.Uniform() * Direction(random);
  return {joint::RotationExp(w) * X.R, X.p + d};
}

correction::GaussNewtonOptions OptionsOf(CorrectionMethod method, double size) {
  correction::GaussNewtonOptions options;
  switch (method) {
    case CorrectionMethod::kQuaternion:
      options.radian = 0.5;
      break;
    case CorrectionMethod::kMetresCutoff:
      options.cutoff = 1e-2;
      [[fallthrough]];
    case CorrectionMethod::kMetres:
      options.radian = 1000;
      break;
    case CorrectionMethod::kPegSize:
      options.radian = size;
      break;
    case CorrectionMethod::kFixedOrigin:
      options.about_object = false;
      break;
    case CorrectionMethod::kCutoff:
      options.cutoff = 1e-2;
      break;
    default:
      break;
  }
  return options;
}

// Whether nothing but the meeting of elements and overlaps may be wrong.
bool Closed(CorrectionOutcome outcome) {
  return outcome == CorrectionOutcome::kCorrected || outcome == CorrectionOutcome::kElementsApart ||
         outcome == CorrectionOutcome::kPenetrates;
}

struct Prepared {
  explicit Prepared(const std::string& name, FrameOrigin origin = FrameOrigin::kModel)
      : table(origin == FrameOrigin::kModel
                  ? correction::TableRelationNamed(name)
                  : correction::WithOriginAtContacts(correction::TableRelationNamed(name))),
        models(correction::ModelsOf(table.moving, table.fixed)),
        relation(correction::RelationOf(table)),
        nearest(models, relation),
        turn_first(models, relation, {{0, 0, 0}, 0, true}) {}
  correction::TableRelation table;
  correction::Models models;
  correction::Relation relation;
  correction::NearestPose nearest, turn_first;
};

std::pair<Transform, CorrectionOutcome> Corrected(const Prepared& p, CorrectionMethod method,
                                                  const Transform& X0) {
  switch (method) {
    case CorrectionMethod::kLinear: {
      const auto answer = correction::CorrectLinearly(p.models, p.relation, X0);
      return {answer.X_FM, answer.outcome};
    }
    case CorrectionMethod::kNearest:
    case CorrectionMethod::kNearestRotationFirst: {
      const auto answer = (method == CorrectionMethod::kNearest ? p.nearest : p.turn_first).Find(X0);
      return {answer.X_FM, answer.outcome};
    }
    default: {
      const auto answer = correction::CorrectByGaussNewton(p.models, p.relation.contacts, X0,
                                                           OptionsOf(method, p.models.size));
      return {answer.X_FM, answer.outcome};
    }
  }
}

CorrectionCell Try(const std::string& name, FrameOrigin frame, int trials) {
  const Prepared p(name, frame);
  const Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  const auto rows = RunTrials(
      trials, 2 + 3 * static_cast<int>(kCorrectionMethods), [&](std::uint64_t seed, double* values) {
        const Transform X0 = Contaminated(*p.relation.realisation, seed);
        const auto put = [&](const Transform& X) {
          const auto moved = correction::DisplacementBetween(X0, X, origin);
          *values++ = moved.rotation / kDegree;
          *values++ = moved.translation;
        };
        put(*p.relation.realisation);
        for (size_t k = 0; k < kCorrectionMethods; ++k) {
          const auto [X, outcome] = Corrected(p, static_cast<CorrectionMethod>(k), X0);
          *values++ = static_cast<double>(outcome);
          put(X);
        }
      });
  CorrectionCell cell;
  cell.relation = name;
  const algebra::MotionDof dof = ComputeMotionDof(p.table.found.relation);
  cell.restricted_translation = dof.translation.restricted;
  cell.restricted_rotation = dof.rotation.restricted;
  cell.noise_turn = MomentsOf(rows[0]);
  cell.noise_shift = MomentsOf(rows[1]);
  for (size_t k = 0; k < kCorrectionMethods; ++k) {
    CorrectionTally& tally = cell.methods[k];
    std::vector<double> turns, shifts, closed_turns, closed_shifts;
    for (size_t i = 0; i < rows[0].size(); ++i) {
      const auto outcome = static_cast<CorrectionOutcome>(rows[2 + 3 * k][i]);
      const double turn = rows[3 + 3 * k][i], shift = rows[4 + 3 * k][i];
      ++tally.trials;
      ++tally.outcomes[static_cast<size_t>(outcome)];
      if (Closed(outcome)) closed_turns.push_back(turn), closed_shifts.push_back(shift);
      if (outcome == CorrectionOutcome::kCorrected) turns.push_back(turn), shifts.push_back(shift);
      if (static_cast<CorrectionMethod>(k) == CorrectionMethod::kLinear)
        cell.most_turn_beyond = std::max(cell.most_turn_beyond, std::abs(turn - rows[0][i]));
    }
    tally.closed = closed_turns.size(), tally.corrected = turns.size();
    if (turns.size() > 1) tally.turn = MomentsOf(turns), tally.shift = MomentsOf(shifts);
    if (closed_turns.size() > 1)
      tally.turn_if_closed = MomentsOf(closed_turns), tally.shift_if_closed = MomentsOf(closed_shifts);
  }
  return cell;
}

int CorrectionTrialsFor(Effort effort) {
  constexpr std::array trials = {200, 10000, 40000};
  return trials[static_cast<size_t>(effort)];
}

}  // namespace

std::string NameOf(CorrectionMethod method) {
  constexpr std::array names = {"millimetres, radians",
                                "millimetres, unit quaternion",
                                "metres, radians",
                                "a radian counts as the peg's size",
                                "about the fixed origin",
                                "millimetres, radians, singular values cut at 1/100",
                                "metres, radians, cut at 1/100",
                                "linear",
                                "nearest",
                                "nearest, rotation first"};
  return names[static_cast<size_t>(method)];
}

const std::vector<CorrectionCell>& CorrectionCellsFor(Effort effort, FrameOrigin origin) {
  static std::mutex mutex;
  static std::map<std::pair<Effort, FrameOrigin>, std::vector<CorrectionCell>> kept;
  const std::lock_guard lock(mutex);
  auto& cells = kept[{effort, origin}];
  if (cells.empty())
    for (const std::string& name : correction::TableRelationNames())
      cells.push_back(Try(name, origin, CorrectionTrialsFor(effort)));
  return cells;
}

const CorrectionCell& CellNamed(const std::vector<CorrectionCell>& cells, const std::string& relation) {
  const auto cell =
      std::find_if(cells.begin(), cells.end(), [&](const auto& c) { return c.relation == relation; });
  if (cell == cells.end()) throw PreconditionError("vision correction: no relation " + relation);
  return *cell;
}

OptimalityTally CompareWithIpopt(const std::string& relation, size_t trials) {
  const Prepared p(relation);
  OptimalityTally tally;
  tally.trials = trials;
  for (size_t seed = 0; seed < trials; ++seed) {
    const Transform X0 = Contaminated(*p.relation.realisation, seed);
    const auto ours = p.nearest.Find(X0);
    tally.answered += ours.outcome == CorrectionOutcome::kCorrected;
    double best = HUGE_VAL;
    for (const Transform& start : {X0, *p.relation.realisation}) {
      const auto ipopt = correction::NearestPoseByIpopt(p.models, p.relation, X0, start);
      if (ipopt.optimal && ipopt.outcome == CorrectionOutcome::kCorrected)
        best = std::min(best, ipopt.distance);
    }
    if (best == HUGE_VAL) continue;
    ++tally.compared;
    const double ratio = ours.distance / best;
    tally.largest_ratio = std::max(tally.largest_ratio, ratio);
    tally.farther += !(ratio <= 1.01);
  }
  return tally;
}

}  // namespace tact::provers
