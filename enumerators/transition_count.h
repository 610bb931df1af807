/// @file
/// How often each of the 30 kinds of DOF-transitions appears, in translation and in rotation, over families of solids.
/// Model   Counted are pairs of neighbouring contact formations, each both ways: by an infinitesimal translation
///         (contact_formation.h), told apart by how many dimensions the set of translations loses - one is what a motion
///         in a general direction meets first, more need aim -, and by a tilt (turned_contact.h). Three readings: by
///         direction (dof_pairing.h, in the limit of the motion), forced by the counts, and every pair of an index
///         that falls and one that rises.
/// Units   A pair of solids is a unit. Units can be counted in any order, on any machines, and merged.
/// Cost    about a second a unit, some seconds with tilts.
#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "enumerators/solid_family.h"
#include "enumerators/turned_contact.h"

namespace tact::enumerators {

enum class Measure {
  kTransitions,   // from, to: whether the relation before, after is singular
  kDimensions,    // from, to: of the formations before and after (translations only)
  kSameDofs,      // no index changes
  kByDirection,   // motion, from, to: a DofTransition
  kForced,        // likewise
  kAllPairs,      // likewise
  kOnlyByCounts,  // likewise: the counts allow it, and no direction goes so
  kHidden,        // likewise: a direction goes so, and the counts do not show it
  kSubSkills,  // of transitions that change an index; to: what the rules name, a bit each; from: 1 if singular
               // before, and 2 more if singular after
  kMakeAndDetach,  // the rules name both, in one motion or in two
  kCritical,       // by the rule
  kAmbiguous,
  kLawTried,   // from: a law of TransitionLaws()
  kLawBroken,  // likewise
};

struct TallyKey {
  Measure measure = Measure::kTransitions;
  int lost_dimensions = 0;  // by a translation 1, 2 or 3; 0: by a tilt
  bool opens = false;       // out of the formation where more touches
  int motion = 0, from = 0, to = 0;
  friend auto operator<=>(const TallyKey&, const TallyKey&) = default;
};

/// Where a transition is: the formation where more touches at its pose, the other at a pose from which a straight motion, or
/// turning back, leads there.
struct TransitionPlace {
  size_t unit = 0;
  algebra::Vector3 border, open;
  std::optional<Turn> turn;  // then `open` equals `border`
  friend bool operator==(const TransitionPlace&, const TransitionPlace&) = default;
};

struct Tally {
  uint64_t count = 0;
  TransitionPlace first;
  friend bool operator==(const Tally&, const Tally&) = default;
};

struct TransitionCount {
  uint64_t pairs = 0, cells = 0, formations = 0, uneven_formations = 0, borders = 0, tilts = 0,
           undecided_tilts = 0;
  std::map<TallyKey, Tally> tallies;

  uint64_t Count(const TallyKey& key) const;
  friend bool operator==(const TransitionCount&, const TransitionCount&) = default;
};

/// What holds of every transition by a translation.
struct TransitionLaw {
  std::string id, statement;
};
const std::vector<TransitionLaw>& TransitionLaws();

TransitionCount CountTransitions(const SolidPair& pair, size_t unit);

/// Adds the part's counts; of two first places the one of the smaller unit stays.
void Merge(TransitionCount* total, const TransitionCount& part);

/// The moving solid's poses where more touches, and where less.
struct PlacePoses {
  algebra::Pose border, open;
};
PlacePoses PosesOf(const TransitionPlace& place);

}  // namespace tact::enumerators
