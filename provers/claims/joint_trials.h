/// @file
/// The simulation experiments of [thesis, 4.5.2 and 4.6.3]: joints, poses and noise drawn from a seed.
/// Model   The joint's frames lie at random in both links, their orientations uniform, their origins at one distance
///         from each link's. A pose is the joint's at its coordinate, then, in B, with vision noise of up to 5 degrees and
///         10 mm (robot/perception/vision_noise.h).
/// Units   metre, radian.
/// Exact   a trial follows from its seed alone, whatever thread draws it.
#pragma once

#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "provers/ledger.h"
#include "robot/joint/joint.h"

namespace tact::provers {

inline constexpr double kDegree = std::numbers::pi / 180;
inline constexpr double kMillimetre = 1e-3;
inline constexpr double kMostTurn = 5 * kDegree;        // of the noise
inline constexpr double kMostShift = 10 * kMillimetre;  // of the noise

/// How the poses lie over the span of the joint's coordinates, which the thesis does not say: in equal steps from end
/// to end (two coordinates grow together), on a square grid (two coordinates only), at random.
enum class Placing { kEqual, kGrid, kRandom };

struct TrialSetup {
  joint::JointType type = joint::JointType::kRevolute;
  double amount = 0;  // the span of each coordinate
  int poses = 0;
  Placing placing = Placing::kEqual;
  double distance = 0;  // of the joint's origin from each link's
  double pitch = 0;
};

struct Trial {
  joint::Joint truth;
  std::vector<joint::Transform> exact, noisy;
};

/// The poses come in the order of the first coordinate.
Trial DrawTrial(const TrialSetup& setup, std::uint64_t seed);

/// measure(seed, values) for the seeds 0 to trials - 1 on two threads; row k of the result holds value k of every
/// trial.
std::vector<std::vector<double>> RunTrials(
    int trials, int values, const std::function<void(std::uint64_t seed, double* values)>& measure);

/// The angle between the lines along two directions, in [0, pi/2].
double LineAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// How many trials a cell of a table gets.
int TrialsFor(Effort effort);

}  // namespace tact::provers
