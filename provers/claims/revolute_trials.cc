#include "provers/claims/revolute_trials.h"

#include <mutex>

#include "robot/joint/least_squares.h"
#include "robot/joint/thesis_estimator.h"

namespace tact::provers {
namespace {

using Eigen::Vector3d;
using joint::AxisPair;
using joint::Joint;

constexpr double kSameOptimum = 1e-3;  // degree

struct PlacedCentre {
  Placing placing;
  double distance;
};
constexpr std::array<PlacedCentre, 5> kSettings = {{{Placing::kEqual, kNearCentre},
                                                    {Placing::kRandom, kNearCentre},
                                                    {Placing::kEqual, 0},
                                                    {Placing::kEqual, 30 * kMillimetre},
                                                    {Placing::kEqual, 100 * kMillimetre}}};

AxisPair AxesOf(const Joint& joint) { return {joint.X_AJ.R.col(2), joint.X_BJ.R.col(2)}; }

void MeasureAxes(const AxisPair& found, const AxisPair& truth, double* values) {
  values[0] = LineAngle(found.l_A, truth.l_A) / kDegree;
  values[1] = LineAngle(found.l_B, truth.l_B) / kDegree;
}

void MeasureCentres(const Joint& found, const Joint& truth, double* values) {
  const AxisPair axes = AxesOf(truth);
  const Vector3d A = found.X_AJ.p - truth.X_AJ.p, B = found.X_BJ.p - truth.X_BJ.p;
  const double along = (A.dot(axes.l_A) + B.dot(axes.l_B)) / 2;
  values[kLineA] = A.cross(axes.l_A).norm() / kMillimetre;
  values[kLineB] = B.cross(axes.l_B).norm() / kMillimetre;
  values[kPointA] = (A - along * axes.l_A).norm() / kMillimetre;
  values[kPointB] = (B - along * axes.l_B).norm() / kMillimetre;
}

void Measure(const TrialSetup& setup, std::uint64_t seed, double* values) {
  const Trial trial = DrawTrial(setup, seed);
  const AxisPair truth = AxesOf(trial.truth);
  const Joint found = FitAsInThesis(setup.type, trial.noisy).joint;
  joint::CgOptions early;
  early.tolerance = kEarlyTolerance;
  const auto [i, j] = NearestQuarterTurn(trial.exact);
  MeasureAxes(AxesOf(found), truth, values + kAxisA);
  MeasureAxes(AxesOf(FitAsInThesis(setup.type, trial.noisy, early).joint), truth, values + kEarlyAxisA);
  MeasureAxes(MethodA(trial.noisy), truth, values + kMethodAxisA);
  MeasureAxes(AxisBetween(trial.noisy[i], trial.noisy[j]), truth, values + kTrueMethodAxisA);
  MeasureCentres(found, trial.truth, values);
  values[kGap] = LineAngle(AxesOf(found).l_A, AxesOf(FitLeastSquares(setup.type, trial.noisy)).l_A) / kDegree;
}

std::vector<RevoluteCell> Run(Effort effort) {
  std::vector<RevoluteCell> cells;
  for (const PlacedCentre& setting : kSettings) {
    const bool full_measure = setting.distance == kNearCentre;
    for (const int span : kSpans) {
      for (const int poses : kPoseCounts) {
        const TrialSetup setup{
            joint::JointType::kRevolute, span * kDegree, poses, setting.placing, setting.distance, 0};
        const auto rows =
            RunTrials(TrialsFor(effort), kRevoluteValues, [&](std::uint64_t seed, double* values) {
              if (full_measure) return Measure(setup, seed, values);
              const Trial trial = DrawTrial(setup, seed);
              MeasureCentres(FitLeastSquares(setup.type, trial.noisy), trial.truth, values);
            });
        RevoluteCell& cell = cells.emplace_back();
        cell.placing = setting.placing;
        cell.span = span;
        cell.poses = poses;
        cell.distance = setting.distance;
        for (size_t k = 0; k < cell.values.size(); ++k) cell.values[k] = MomentsOf(rows[k]);
        for (const double gap : rows[kGap]) cell.far_from_optimum += gap > kSameOptimum;
      }
    }
  }
  return cells;
}

}  // namespace

const std::vector<RevoluteCell>& RevoluteCellsFor(Effort effort) {
  static std::array<std::vector<RevoluteCell>, 3> cells;
  static std::array<std::once_flag, 3> done;
  const auto size = static_cast<size_t>(effort);
  std::call_once(done[size], [&] { cells[size] = Run(effort); });
  return cells[size];
}

std::vector<const RevoluteCell*> NineCells(const std::vector<RevoluteCell>& cells, Placing placing,
                                           double distance) {
  std::vector<const RevoluteCell*> nine;
  for (const RevoluteCell& cell : cells) {
    if (cell.placing == placing && cell.distance == distance) nine.push_back(&cell);
  }
  return nine;
}

}  // namespace tact::provers
