/// @file
/// Which of two parts a scanned point belongs to, by which part's motion explains it in the other scans.
/// Model   A point that moves with a part lies on the surface that another scan shows. Its cost under a motion is the squared
///         distance from there in deviations, less what noise explains, between 0 and kMostCost; a point that meets nothing
///         has the highest cost, whether the motion is wrong or the place was hidden: if it is hidden under both motions, the
///         costs cancel. Evidence is half the difference of the costs. Neighbours count, too: m_i = tanh(e_i + c sum of m_j)
///         over the neighbours j, the mean field of an Ising model so weakly coupled that evidence fades away from where it
///         arose: points that nothing speaks for stay undecided.
/// Units   evidence positive for the first part.
#pragma once

#include <cstdint>
#include <vector>

#include "robot/joint/transform.h"
#include "robot/perception/surface.h"

namespace tact::perception {

enum class Part : std::uint8_t { kFirst, kSecond, kUndecided };

inline constexpr double kExplainedByNoise = 4;  // squared deviations: 95 % of the points
inline constexpr double kMostCost = 5;
inline constexpr double kCoupling = 0.9;  // of all neighbours together; from 1 on, evidence would not fade
inline constexpr double kMostEvidence =
    1;  // of one point: not enough to be decided without neighbours that agree
inline constexpr double kDecided = 0.85;  // |m| from which a point counts as decided

/// The cost of each point of the source under the motion.
std::vector<double> CostOf(const Surface& source, const Surface& target, const joint::Transform& X_TS,
                           double deviation);

/// m of each point. Pre: the surface has neighbours.
std::vector<double> MeanField(const Surface& surface, const std::vector<double>& evidence);

/// The parts that m decides.
std::vector<Part> PartsBy(const std::vector<double>& mean_field);

}  // namespace tact::perception
