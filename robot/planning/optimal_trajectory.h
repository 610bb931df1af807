/// @file
/// The optimal trajectory from one contact relation to another, in closed form [thesis, A.2-A.6].
/// Model   Turns about constant axes first (rotational_case.h), the location along them solved for while C_s is maintained
///         (angle_and_location.h), then a straight line (translational_case.h) to where C_e holds [thesis, A.6.3].
///         Where the end has fewer restricted DOFs (in rotation; if they are equal, in translation) the inverse
///         transition is planned and inverted: then C_e is what is maintained, and the line comes first.
///         Obstacles are not avoided (A.1, second assumption); trajectory_check.h finds them.
/// Departs The restricted DOFs may go opposite ways, which A.2 excludes (see the ledger, thesis.A.2.opposite-ways): the
///         rotational ones then decide, and a note says so.
/// Frames  X_FM, the moving solid's pose in the fixed one's frame.
/// Units   the solids' length unit, radian.
/// Errors  none: what cannot be done is a failure with its reason; samples then end where it came up.
#pragma once

#include <string>
#include <vector>

#include "robot/planning/rotational_case.h"
#include "robot/planning/translational_case.h"

namespace tact::planning {

struct SolidPair {
  algebra::Polyhedron moving, fixed;
  recognition::SolidF moving_f, fixed_f;
  double size = 0;  // of the moving solid
};
SolidPair MakeSolidPair(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed);

/// A contact relation with one configuration in which it holds.
struct ContactState {
  Relation relation;
  joint::Transform X_FM;
  std::optional<Ranks> ranks;  // none: told from the rows with kRankTolerance
};

/// A gap that should be zero and is larger than this share of the moving solid's size is a failure: rounding leaves 1e-15.
inline constexpr double kViolationTolerance = 1e-9;
/// Turns (radian) and shares of the size below which nothing moves.
inline constexpr double kNoMotion = 1e-12;

/// A turn about an axis direction, or a straight line.
struct Segment {
  Turn turn;                              // angle zero: a line
  Eigen::Vector3d displacement{0, 0, 0};  // from its first to its last sample
  size_t first = 0, last = 0;             // samples
  bool is_turn() const { return turn.angle != 0; }
};

struct Sample {
  joint::Transform X_FM;
  double violation = 0;   // the largest |gap| of the relation that should hold
  bool at_other = false;  // that is the one which is not maintained on the way, at its end
};

struct Trajectory {
  Ranks start, end;      // restricted DOFs
  bool inverse = false;  // planned backwards
  TurnAnswer turns;      // of the direction in which it was planned
  int straight = 0;      // which translational case; 0: no straight line was asked for
  std::vector<Segment> segments;
  std::vector<Sample> samples;
  double violation = 0;  // the largest of the samples'
  double angle = 0;      // of all turns
  double distance = 0;   // of the location's way, sample by sample
  std::vector<std::string> notes;
  std::string failure;
};

/// steps: samples a segment, at least 1.
Trajectory PlanOptimalTrajectory(const SolidPair& solids, const ContactState& start, const ContactState& end,
                                 int steps);

/// "rotational 4, A.6.1 edge-face + translational 1, inverse".
std::string CaseText(const Trajectory& trajectory);

}  // namespace tact::planning
