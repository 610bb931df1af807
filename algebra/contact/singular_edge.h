/// @file
/// Which first-order motions a parallel edge-edge contact permits: what its end points alone do not say.
/// Model   The moving edge must stay out of the open wedge that its two separate planes cut off: there must be
///         no point between the ends where both products of plane and velocity are negative. Velocity is
///         linear along the edge, so this is a condition on the four products at the ends; it is quadratic,
///         not a union of linear systems. At the ends alone the condition is weaker [ledger,
///         thesis.2.1.singular-edges].
/// Exact   rational.
#pragma once

#include "algebra/exact/rational.h"

namespace tact::algebra {

/// The products n . v of the two separate planes with the velocities of the edge's two ends.
struct EdgeRates {
  Rational first_end_first_plane, first_end_second_plane;
  Rational second_end_first_plane, second_end_second_plane;
};

/// Whether every point of the edge, ends included, has a plane with n . v >= 0.
bool PermitsEdgeMotion(const EdgeRates& rates);

}  // namespace tact::algebra
