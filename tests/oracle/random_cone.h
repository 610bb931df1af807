/// @file
/// Random cones for comparisons with outside tools, degenerate on purpose.
/// Model   A cone draws a dimension of 2 to 7, up to 14 inequalities and now and then an equality. A row is drawn freely, or is tied
///         to earlier ones (a multiple, an opposite, a sum), or, in dimension 6, is a contact's row [ p x n | n ]. One cone in
///         ten has entries near 2^40, beyond what 64 bits carry through.
/// Cost    the cone of a number is made without those before it.
#pragma once

#include <cstdint>

#include "algebra/cone/cone.h"

namespace tact::oracle {

/// Cone number `index` of the stream that `seed` names. No row is zero.
algebra::HalfspaceCone RandomCone(uint64_t seed, uint64_t index);

/// The rows, each primitive, each once, in lexicographic order.
algebra::IntegerMatrix SortedPrimitive(const algebra::IntegerMatrix& rows);

}  // namespace tact::oracle
