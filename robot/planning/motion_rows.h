/// @file
/// Which motions maintain a contact relation in a pose, to first order: ranks and solution spaces [thesis, A.1].
/// Model   Rows [ p x n | n ] of every point contact, S0 = w, S1 = v. F is their last three columns (A.4). G is what is
///         left for w alone (A.7): G w = 0 exactly if some v has (p x n) . w + n . v = 0 for all rows. So
///         rank F and rank G are the restricted DOFs in translation and in rotation, and rank G = rank [A] - rank F.
/// Method  The null space of F from F^T F; that of G from the Schur complement of the rows' Gram matrix, which is
///         G^T G for the G of orthonormal combinations.
/// Frames  the fixed solid's, F.
#pragma once

#include <optional>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::planning {

/// A singular value below this share of what it could be counts as zero: the sine of an angle between normals, or
/// a rate of a gap over the solid's size times a turn. Exact poses in doubles err by 1e-15, poses that a tracker
/// gives by 1e-3 and more.
inline constexpr double kRankTolerance = 1e-6;

/// Restricted DOFs known exactly.
struct Ranks {
  int translation = 0, rotation = 0;
  friend bool operator==(const Ranks&, const Ranks&) = default;
};

using Basis = std::vector<Eigen::Vector3d>;  // orthonormal

struct MotionRows {
  Ranks ranks;
  Basis translations;  // of F's null space, T
  Basis axes;          // of G's null space, A
};

using Relation = std::vector<recognition::PointContact>;

/// size: a length of the moving solid, that a turn is compared with. With ranks given the bases have the sizes that
/// belong to them.
MotionRows MotionRowsOf(const Relation& relation, const recognition::SolidF& moving,
                        const recognition::SolidF& fixed, const joint::Transform& X_FM, double size,
                        const std::optional<Ranks>& ranks = {});

/// The part of v that is perpendicular to the basis.
Eigen::Vector3d PartOutside(const Basis& basis, const Eigen::Vector3d& v);

/// The largest distance between two of its vertices' coordinates along an axis.
double SizeOf(const recognition::SolidF& solid);

}  // namespace tact::planning
