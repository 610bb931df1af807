/// @file
/// DOF classes: the motion DOFs that non-singular contact relations have, under every reading of which indices tell two
/// of them apart [thesis, 2.3].
/// Model   With r_t = 3 - m_t, r_r = 3 - m_r, and q = d_r2 + c_r, a class is what the lemmas of docs/dof-classes.md leave
///         of all tuples whose sums are right; each one left has a witness, so the list is complete and exact.
/// Source  docs/dof-classes.md has the lemmas with their proofs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algebra/contact/motion_dof.h"

namespace tact::enumerators {

/// Which indices tell two relations apart.
struct DofDefinition {
  std::string name;                  // "translation, rotation with types, all motion"
  std::vector<std::string> indices;  // "translation.maintaining", ..., "rotation.detaching_type1", ...
};

/// Translation, rotation, rotation with Types I and II, all motion, and every combination: eleven.
const std::vector<DofDefinition>& DofDefinitions();

std::vector<int> IndexValues(const algebra::MotionDof& dof, const DofDefinition& definition);

/// A law that every non-singular relation's DOFs obey.
struct DofLemma {
  std::string id;         // "pointed-normals"
  std::string statement;  // in a sentence
  bool (*holds)(const algebra::MotionDof& dof);
};
const std::vector<DofLemma>& DofLemmas();
/// What holds besides if every face is parallel to a coordinate plane.
const std::vector<DofLemma>& BoxLemmas();

/// Every tuple of non-negative indices with the sums that the definitions and Proposition 3 give.
std::vector<algebra::MotionDof> DofCandidates();

/// The first lemma that the tuple breaks.
std::optional<size_t> ExcludingLemma(const algebra::MotionDof& candidate);

/// The candidates that no lemma excludes, sorted: the DOF classes, 142.
std::vector<algebra::MotionDof> DofClasses();
/// Those of solids whose faces are all parallel to coordinate planes, 139.
std::vector<algebra::MotionDof> BoxClasses();
/// Those of singular relations, 396: the DOFs of the other contacts are among the 142, and the restricted DOFs are at least
/// theirs, with two in translation, and at most three each.
std::vector<algebra::MotionDof> SingularClasses();
/// How many of the DOFs the definition tells apart.
size_t CountDistinct(const std::vector<algebra::MotionDof>& dofs, const DofDefinition& definition);

/// The fewest contacts that a relation of that class can have: the rank of its rows, and one more if some motion
/// is blocked, since c_a + 1 rows at least must then cancel.
size_t FewestContacts(const algebra::MotionDof& dof);

}  // namespace tact::enumerators
