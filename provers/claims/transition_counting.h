/// @file
/// Transition counts over the families of solids, as the claims about them ask for them.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "enumerators/transition_count.h"
#include "provers/ledger.h"

namespace tact::provers {

struct FamilyCount {
  std::string family;
  enumerators::TransitionCount count;
};

struct CountedFamilies {
  std::vector<enumerators::SolidPair> pairs;  // by unit
  std::vector<FamilyCount> families;
  enumerators::TransitionCount total;
};

/// Counted once for each effort, whichever claims ask, on whichever threads.
const CountedFamilies& FamiliesFor(Effort effort);

/// Over all lost dimensions and tilts.
uint64_t Sum(const enumerators::TransitionCount& count, enumerators::Measure measure, bool opens, int motion,
             int from, int to);
/// Closing and opening.
uint64_t BothWays(const enumerators::TransitionCount& count, enumerators::Measure measure, int motion,
                  int from, int to);

std::string Digits(uint64_t count);
/// "2.13 %".
std::string Share(uint64_t part, uint64_t whole);

/// What was counted, for people.
std::string BoundOf(const CountedFamilies& counted);

using CountedPlace = std::pair<enumerators::TallyKey, enumerators::TransitionPlace>;

/// The first place with that measure and those kinds; straight motions before tilts.
std::optional<CountedPlace> FirstPlace(const enumerators::TransitionCount& count,
                                       enumerators::Measure measure, bool opens, int motion, int from,
                                       int to);

/// Adds drawings of the relations before and after, and a certificate that restates both.
void AddExample(const CountedFamilies& counted, const std::string& claim, const std::string& name,
                const std::string& caption, const CountedPlace& at, Outcome* outcome);

/// [thesis, 2.6]: thesis.2.6.rules-decide.
Claim RulesDecideClaim();

}  // namespace tact::provers
