/// @file
/// A start by consensus where many poses are wrong: joints through few poses drawn at random, judged by all.
/// Model   Each sample takes as few poses as determine the type and fits them by least squares (two-axis: from one
///         random guess of an axis). Its joint is judged by the median error of orientation and of location over the
///         poses; the least product of both wins. With a share e of wrong poses a sample of m is clean with probability
///         (1 - e)^m.
/// Exact   no; the same seed gives the same answer.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "robot/joint/joint.h"

namespace tact::joint {

struct Consensus {
  Joint joint;
  std::vector<double> weights;  // of each pose: 1 near the joint, else 0
};

/// Pre: poses not empty.
Consensus FindConsensus(JointType type, std::span<const Transform> poses, int samples, std::uint64_t seed);

}  // namespace tact::joint
