/// @file
/// The prismatic joint's trials of [thesis, 4.5.2], re-run once for all claims about them.
/// Units   degree, millimetre: as printed.
#pragma once

#include <array>

#include "provers/claims/joint_trials.h"
#include "provers/claims/printed_table.h"

namespace tact::provers {

/// What a trial measures: angles between directions.
enum PrismaticValue {
  kDirectionA,  // conjugate gradients run until they converge
  kDirectionB,
  kFirstPoseA,  // (4.3) with the first pose's orientation, the initial guess
  kPitchOnlyA,  // with its pitch fitted, its yaw and roll kept
  kDifference,  // of the two errors, A less B
  kPrismaticValues
};

inline constexpr std::array kLengths = {50, 100, 200};  // millimetre

using PrismaticCell = std::array<Moments, kPrismaticValues>;
/// 50 mm with 50, 100, 200 poses, then 100 mm, then 200 mm.
using PrismaticCells = std::array<PrismaticCell, 9>;

const PrismaticCells& PrismaticCellsFor(Placing placing, Effort effort);

}  // namespace tact::provers
