/// @file
/// The steps between the ten translational kinds of contact relations, under each definition of a step.
/// Model   A relation is a set of normals; its kind is (m, d, c) in translation. A step adds contacts, and counts if
///         the kind changes.
/// Source  [thesis, 2.3] cites 13 kinds of transitions between ten kinds of relations.
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tact::enumerators {

/// Maintaining, detaching, constraining.
using TranslationKind = std::array<int, 3>;
/// The ten, those with more maintaining, then more detaching DOFs first: steps lead to later ones.
std::vector<TranslationKind> TranslationKinds();

using KindSteps = std::set<std::pair<TranslationKind, TranslationKind>>;

struct StepDefinition {
  std::string name;
  KindSteps steps;
};

/// Over all sets of at most `largest` of the 26 normals with entries -1, 0, 1: one contact; one contact that a
/// translation keeping the others brings about; one or several such contacts met head on; the two walls of a slot; ...
std::vector<StepDefinition> TranslationSteps(size_t largest);

}  // namespace tact::enumerators
