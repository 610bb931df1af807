/// @file
/// The algorithm of Fig. 2.2, literally: from a basis of screws to one whose translations stand apart.
#pragma once

#include <vector>

#include "algebra/exact/integer.h"

namespace tact::provers {

/// A screw, angular part first, as six integers.
using Screw = std::vector<algebra::Integer>;

struct ReducedBasis {
  std::vector<Screw> screws;
  int translations = 0;  // screws with a zero angular part
  int rounds = 0;        // times that steps 2 to 4 ran
};

/// Steps 1 to 5 [thesis, Fig. 2.2]. Step 3 leaves open which element of the combination goes: `remove_last` takes
/// the last, otherwise the first. Precondition: the screws are linearly independent.
ReducedBasis ReduceBasis(std::vector<Screw> screws, bool remove_last);

}  // namespace tact::provers
