/// @file
/// The simulation of [thesis, 2.8.3]: poses of three kinds of contact relation, contaminated and corrected.
/// Model   The relations of robot/correction/table_relations.h, the noise of joint_trials.h. A displacement is the turn and
///         the shift of the moving frame's origin from the pose seen to the pose corrected. That origin is the model's, in
///         the peg's middle, or lies at the contacts.
/// Units   degree, millimetre.
/// Exact   a trial follows from its seed alone.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "provers/claims/printed_table.h"
#include "provers/ledger.h"

namespace tact::provers {

/// How the non-linear method may be meant: what a radian counts in the norm of a step, where a turn's centre lies, from
/// which singular value on a direction is free; then the methods that leave nothing open.
enum class CorrectionMethod {
  kLiteral,       // radians and millimetres, about the object's origin, singular values down to rounding
  kQuaternion,    // a unit quaternion: half a radian
  kMetres,        // radians and metres
  kPegSize,       // a radian counts as the peg's size
  kFixedOrigin,   // about the fixed frame's origin
  kCutoff,        // literal, singular values below a hundredth of the largest are zero
  kMetresCutoff,  // metres with that cutoff
  kLinear,
  kNearest,
  kNearestRotationFirst
};
inline constexpr size_t kCorrectionMethods = 10;
std::string NameOf(CorrectionMethod method);

enum class FrameOrigin { kModel, kContacts };

struct CorrectionTally {
  size_t trials = 0, closed = 0, corrected = 0;  // no gaps left; and elements that meet, and no overlap
  Moments turn_if_closed, shift_if_closed, turn, shift;
  std::array<size_t, 7> outcomes{};  // by correction::Outcome
};

struct CorrectionCell {
  std::string relation;
  int restricted_translation = 0, restricted_rotation = 0;
  Moments noise_turn, noise_shift;
  double most_turn_beyond = 0;  // the linear method's turn from the noise's, at most, in degrees
  std::array<CorrectionTally, kCorrectionMethods> methods;
  const CorrectionTally& operator[](CorrectionMethod method) const {
    return methods[static_cast<size_t>(method)];
  }
};

/// In the order of correction::TableRelationNames; computed once an effort.
const std::vector<CorrectionCell>& CorrectionCellsFor(Effort effort,
                                                      FrameOrigin origin = FrameOrigin::kModel);
const CorrectionCell& CellNamed(const std::vector<CorrectionCell>& cells, const std::string& relation);

struct OptimalityTally {
  size_t trials = 0, answered = 0, compared = 0, farther = 0;
  double largest_ratio = 0;
};
/// Nearest poses against the best that Ipopt finds from two starts.
OptimalityTally CompareWithIpopt(const std::string& relation, size_t trials);

}  // namespace tact::provers
