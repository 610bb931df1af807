/// @file
/// The linear vision error correction [thesis, 2.7.3]: where the optimal trajectory from no contact to the relation ends
/// [thesis, A.2 to A.6].
/// Model   The rank of G_e, the relation's equations in the rotation alone [eq. (A.7)], at the realisation decides the turn:
///         0 none, 3 to the realisation's orientation (Case 1), 2 the least turn to one that the turns about the remaining
///         axis lead to (Case 2, eq. (A.20)), 1 a turn about the axis across edge and normal until the edge lies in the
///         face (Case 4 with the cure of A.6.1, eq. (A.22), (A.24), (A.25)); where a relation of rank 1 is neither edge on
///         face nor face on edge, (A.22) itself. Then the least translation after which there are no gaps (Cases 1 to 3:
///         t is projected along T_e), at the orientation found (A.4.3).
/// Departs (A.20) and (A.22) are solved by the angles' closed forms; the projections of A.3.2 are one least-norm solution,
///         which they are.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame.
/// Exact   no: ranks by singular values, kRank.
#pragma once

#include "robot/correction/contact_problem.h"

namespace tact::correction {

/// Singular values below this, times the largest, count as zero: between the rounding of a realisation read from text
/// (1e-12) and the angles that a drawing means (1e-3).
inline constexpr double kRank = 1e-8;

struct Ranks {
  int translation = 0, rotation = 0, all = 0;  // restricted DOFs
  Eigen::MatrixXd axes;  // 3 x (3 - rotation), orthonormal: A_e, the solutions of (A.17)
};
Ranks RanksAt(const Models& models, const std::vector<recognition::PointContact>& contacts,
              const joint::Transform& X_FM);

/// The orientation alone. Pre: the relation has a realisation.
Eigen::Matrix3d LinearOrientation(const Models& models, const Relation& relation,
                                  const joint::Transform& X_FM);

struct LinearAnswer {
  joint::Transform X_FM;
  Outcome outcome = Outcome::kNoRealisation;
};

LinearAnswer CorrectLinearly(const Models& models, const Relation& relation, const joint::Transform& X_FM);

}  // namespace tact::correction
