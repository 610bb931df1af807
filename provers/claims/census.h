/// @file
/// A world's contact relations sorted into classes of equal motion DOFs, and what to make of them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "enumerators/contact_world.h"
#include "provers/certificate_writer.h"
#include "provers/ledger.h"

namespace tact::provers {

/// How many contacts the worlds have at most: where ranks are computed, and where true projections are.
size_t CensusSize(Effort effort);
size_t ProjectionSize(Effort effort);

struct Census {
  enumerators::ContactWorld world;
  size_t count = 0;
  std::vector<CensusClass>
      classes;  // by increasing DOFs; the witness is the first of the world's order: a smallest
};

Census TakeCensus(const enumerators::ContactWorld& world);

/// The class with the given property whose witness has the fewest contacts; nullptr if there is none.
const CensusClass* SmallestClass(const Census& census,
                                 const std::function<bool(const algebra::MotionDof&)>& property);

/// An outcome for linear laws of the DOF indices over a world, with every class and a witness in the certificate: holds to
/// n, or refuted with a smallest counterexample. `prose` begins the evidence.
Outcome LawsHoldThroughout(const enumerators::ContactWorld& world, const std::string& claim_id,
                           const std::vector<Assertion>& laws, const std::string& prose);

/// The first relation of the world for which the statement fails, if there is one.
std::optional<algebra::ContactRelation> FirstFailure(
    const enumerators::ContactWorld& world,
    const std::function<bool(const algebra::ContactRelation&, const algebra::MotionDof&)>& statement);

/// "2 contacts: at (0, 0, 0) with normal (1, 0, 0); at ...".
std::string Describe(const algebra::ContactRelation& relation);

/// An outcome for a statement that must hold throughout a world: holds to n, or refuted with the first failure.
Outcome HoldsThroughout(
    const enumerators::ContactWorld& world, const std::string& claim_id,
    const std::function<bool(const algebra::ContactRelation&, const algebra::MotionDof&)>& statement);

/// A table row "translation 2 1 0 (1) ..." of DOFs for the report.
std::vector<std::string> DofCells(const algebra::MotionDof& dof);
/// The header that goes with DofCells.
std::vector<std::string> DofHeader();

}  // namespace tact::provers
