/// @file
/// Engine results as certificates (docs/certificates.md). Writes them; the checker, which shares no code with
/// this, reads them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "algebra/contact/contact_relation.h"
#include "algebra/contact/dof_transition.h"
#include "algebra/contact/motion_dof.h"
#include "enumerators/contact_world.h"
#include "enumerators/dof_class.h"
#include "provers/certificate.h"

namespace tact::provers {

/// A linear statement about a relation's DOF indices: sum of coefficient * index, compared with zero.
struct Assertion {
  std::vector<std::pair<std::string, int>> sum;
  std::string is;  // "zero", "nonzero", "negative", "positive", "nonnegative"
};

bool Holds(const Assertion& assertion, const algebra::MotionDof& dof);

struct CensusClass {
  algebra::MotionDof dof;
  size_t count = 0;
  algebra::ContactRelation witness;
};

/// The change of an index that the thesis' text states, "translation.singular_maintaining" and the like.
using Changes = std::vector<std::pair<std::string, int>>;

Certificate MotionDofCertificate(const std::string& name, const std::string& claim,
                                 const algebra::ContactRelation& relation,
                                 const std::vector<Assertion>& asserts);
/// The classes of a world with all their members; witnesses are relations of the world.
Certificate CensusCertificate(const std::string& name, const std::string& claim,
                              const enumerators::ContactWorld& world, const std::vector<CensusClass>& classes,
                              const std::vector<Assertion>& asserts);
/// Which complete list of DOF classes (docs/dof-classes.md): of solids of any faces, each witness with the fewest contacts; of
/// axis-parallel ones; of singular relations with their restricted DOFs.
enum class ClassList { kAnyFaces, kAxisParallelFaces, kSingular };
/// A witness for each class of the list, and how many classes each definition tells apart.
Certificate DofClassesCertificate(const std::string& name, const std::string& claim, ClassList list,
                                  const std::vector<algebra::ContactRelation>& witnesses,
                                  const std::vector<enumerators::DofDefinition>& counted);
/// Transitions from each relation to the next; expects names transitions by their place in the sequence.
Certificate TransitionsCertificate(
    const std::string& name, const std::string& claim,
    const std::vector<std::pair<std::string, algebra::ContactRelation>>& relations,
    const std::vector<std::pair<size_t, Changes>>& expects);
/// vectors and reduced: six integers each, angular part first.
Certificate BasisCertificate(const std::string& name, const std::string& claim,
                             const std::vector<std::vector<algebra::Integer>>& vectors,
                             const std::vector<std::vector<algebra::Integer>>& reduced, int translations);
/// A motion legal at both ends of a parallel edge-edge contact and not between (docs/certificates.md).
struct IllReducedEdge {
  algebra::Vector3 first, second;
  std::vector<algebra::Vector3> planes;
  std::vector<algebra::Integer> motion;
  int s = 1, t = 1;
};
Certificate IllReducedEdgeCertificate(const std::string& name, const std::string& claim,
                                      const IllReducedEdge& edge);

}  // namespace tact::provers
