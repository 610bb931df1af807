/// @file
/// The separate planes of two convex pieces that touch in one point [thesis, 2.1].
/// Model   The extreme rays of the cone { n | n . a <= 0 for a in the fixed piece, n . b >= 0 for b in the
///         moving one }: each is a facet normal of the fixed piece, the reverse of one of the moving piece,
///         or square to a ray of each (edge-edge). The motion is legal when some plane's n . v >= 0: v must
///         stay out of the interior of fixed - moving, a convex cone with these facets.
/// Exact   with tolerance zero. A positive tolerance (in the solids' length unit) lets the pieces'
///         directions, which carry the solids' lengths, reach that far over the plane, and takes planes for
///         one that differ by no more.
#pragma once

#include <vector>

#include "algebra/contact/local_cone.h"

namespace tact::algebra {

/// Primitive integer normals, pointing from the fixed to the moving piece; in a canonical order: the fixed
/// piece's, the moving piece's, edge-edge. Empty: the pieces' interiors meet, by more than the tolerance.
std::vector<Vector3> SeparatePlanes(const ConvexPiece& moving, const ConvexPiece& fixed,
                                    const Rational& tolerance);

}  // namespace tact::algebra
