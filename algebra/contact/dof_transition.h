/// @file
/// From two neighbouring contact relations' motion DOFs to DOF-transitions, sub-skills and criticality.
/// Model   [thesis, 2.3-2.6]. Six indices for translation and six for rotation; a DOF-transition pairs an
///         index that decreases with one that increases. Where several indices decrease and several increase,
///         the text does not say how they pair: every pair is listed (`ambiguous` says so; dof_pairing.h pairs
///         them by direction).
#pragma once

#include <array>
#include <string>
#include <vector>

#include "algebra/contact/motion_dof.h"

namespace tact::algebra {

enum class Motion { kTranslation, kRotation };
enum class DofIndex {
  kMaintaining,
  kDetaching,
  kConstraining,
  kSingularMaintaining,
  kSingularDetaching,
  kSingularConstraining
};
constexpr int kDofIndices = 6;

/// "translation", "rotation".
std::string ToString(Motion motion);
/// "maintaining", ..., "singular_constraining".
std::string ToString(DofIndex index);

struct DofTransition {
  Motion motion;
  DofIndex from, to;
  friend auto operator<=>(const DofTransition&, const DofTransition&) = default;
};

/// One of the 20 kinds that Fig. 2.5 calls practical: not between two singular indices, not between
/// maintaining and (singular) constraining [thesis, 2.3.1].
bool IsPractical(const DofTransition& transition);

enum class SubSkill {
  kMakeContactInTranslation,
  kDetachContactInTranslation,
  kSlideInTranslation,
  kType1MakeContactInRotation,
  kType2MakeContactInRotation,
  kDetachContactInRotation,
  kSlideInRotation
};
/// "make-contact-in-translation", "type1-make-contact-in-rotation", ...
std::string ToString(SubSkill skill);

struct Transition {
  std::vector<DofTransition> dof_transitions;
  bool ambiguous = false;
  bool practical = true;
  std::vector<SubSkill> sub_skills;
  bool critical = false;
  std::string why;  // a sentence for each choice
};

/// The six indices of one motion: zero are the singular ones of a non-singular relation and the others of a
/// singular.
std::array<int, kDofIndices> Indices(const MotionDof& dof, Motion motion);
int Restricted(const MotionDof& dof, Motion motion);

/// Every index that falls with every one that rises, by motion, from, to: literally [thesis, 2.3.1].
std::vector<DofTransition> DofTransitionsByCounts(const MotionDof& before, const MotionDof& after);

/// Whether in one motion several indices fall and several rise, so that counts alone do not pair them.
bool IsAmbiguous(const MotionDof& before, const MotionDof& after);

/// The rules of [thesis, 2.6] on the DOF-transitions given, which `ambiguous` says nothing about.
Transition ApplyRules(const MotionDof& before, const MotionDof& after,
                      std::vector<DofTransition> dof_transitions);

/// The rules of [thesis, 2.6], literally: on DofTransitionsByCounts.
Transition AnalyzeTransition(const MotionDof& before, const MotionDof& after);

}  // namespace tact::algebra
