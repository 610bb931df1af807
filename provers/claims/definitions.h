/// @file
/// Motion DOFs read off their definitions, the slow way: full cones and true projections. The claims hold the
/// engine's rank formulas (algebra/contact/motion_dof.h) and the thesis' propositions against these.
/// Cost    a double description of the cone a relation, some 30 to 300 microseconds.
#pragma once

#include "algebra/cone/cone.h"
#include "algebra/contact/contact_relation.h"

namespace tact::provers {

struct Definitions {
  int maintaining_all = 0;          // dim { V | A V = 0 }
  int maintaining_translation = 0;  // dim { v | N v = 0 }
  int maintaining_rotation = 0;     // dim of the angular parts of { A V = 0 }
  int legal_all = 0;                // dim V_a
  int legal_translation = 0;        // dim V_t
  int legal_rotation = 0;           // dim V_r, V_r the projection of V_a to angular parts
  int two_way_rotation = 0;         // dim of the lineality space of V_r
  int rank_g = 0;                   // rank of G, V_r = { s | G s >= 0 } [thesis, eq. (2.6)]
};

/// The rows [ p x n | n ] of every plane.
algebra::IntegerMatrix LegalRows(const algebra::ContactRelation& relation);

/// Precondition: a non-singular relation.
Definitions ByDefinition(const algebra::ContactRelation& relation);

}  // namespace tact::provers
