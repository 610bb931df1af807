#include "enumerators/transition_count.h"

#include <algorithm>
#include <array>

#include "algebra/contact/approach.h"

namespace tact::enumerators {
namespace {

using algebra::DofIndex;
using algebra::DofPairing;
using algebra::DofTransition;
using algebra::FoundContacts;
using algebra::kDofIndices;
using algebra::Motion;
using algebra::MotionDof;
using algebra::MotionPath;
using algebra::Polyhedron;
using algebra::SubSkill;

constexpr std::array<Motion, 2> kMotions = {Motion::kTranslation, Motion::kRotation};

// One way through a pair of neighbours.
struct Passage {
  int lost_dimensions = 0;
  bool opens = false;
  const MotionDof& before;
  const MotionDof& after;
  std::array<DofPairing, 2> pairings;
};

DofPairing Transposed(const DofPairing& pairing) {
  DofPairing result{};
  for (int i = 0; i < kDofIndices; ++i) {
    for (int j = 0; j < kDofIndices; ++j) result[j][i] = pairing[i][j];
  }
  return result;
}

bool Contains(const std::vector<DofTransition>& list, const DofTransition& t) {
  return std::find(list.begin(), list.end(), t) != list.end();
}

// Whether some direction of a motion goes from one of the first to one of the second.
bool AnyDirection(const Passage& passage, bool (*wanted)(DofIndex from, DofIndex to)) {
  for (const DofPairing& pairing : passage.pairings) {
    for (int i = 0; i < kDofIndices; ++i) {
      for (int j = 0; j < kDofIndices; ++j) {
        if (i != j && pairing[i][j] != 0 && wanted(static_cast<DofIndex>(i), static_cast<DofIndex>(j)))
          return true;
      }
    }
  }
  return false;
}

bool Rises(const Passage& passage) {
  return passage.after.translation.constraining > passage.before.translation.constraining ||
         passage.after.rotation.constraining > passage.before.rotation.constraining;
}

class Counter {
 public:
  Counter(const SolidPair& pair, size_t unit) : pair_(pair), unit_(unit) {}

  TransitionCount Run() {
    const FormationComplex complex = FindFormations(pair_.moving, pair_.fixed);
    count_.pairs = 1;
    count_.cells = complex.cells;
    count_.formations = complex.formations.size();
    count_.borders = complex.borders.size();
    for (const Formation& f : complex.formations) count_.uneven_formations += f.uneven ? 1 : 0;
    for (const Border& border : complex.borders) {
      const Formation &open = complex.formations[border.open], &closed = complex.formations[border.border];
      place_ = {unit_, border.border_pose, border.open_pose, std::nullopt};
      dimensions_ = {open.dimension, closed.dimension};
      AddBothWays(MotionPath::Line(border.open_pose - border.border_pose),
                  FindContacts(Moved(border.open_pose), pair_.fixed, 0), border.border_pose);
    }
    if (!pair_.turns) return std::move(count_);
    const TurnedContacts turned = FindTurnedContacts(pair_.moving, pair_.fixed, complex);
    count_.tilts = turned.found.size();
    count_.undecided_tilts = turned.undecided;
    for (const TurnedContact& tilt : turned.found) {
      const algebra::Vector3& pose = complex.formations[tilt.border].pose;
      place_ = {unit_, pose, pose, tilt.turn};
      dimensions_.reset();
      AddBothWays(PathOf(tilt.turn), tilt.contacts, pose);
    }
    return std::move(count_);
  }

 private:
  Polyhedron Moved(const algebra::Vector3& pose) const { return Transform(pair_.moving, {{}, pose}); }

  // `contacts` are those that the motion keeps, at its far end.
  void AddBothWays(const MotionPath& path, const FoundContacts& contacts,
                   const algebra::Vector3& border_pose) {
    const Polyhedron moving = Moved(border_pose);
    const algebra::ContactRelation relation = FindContacts(moving, pair_.fixed, 0).relation;
    const algebra::Approach approach = ApproachEnd(moving, pair_.fixed, path, contacts);
    const MotionDof open = engine_.Compute(approach.relation), closed = engine_.Compute(relation);
    std::array<DofPairing, 2> closing{}, opening{};
    for (size_t i = 0; i < kMotions.size(); ++i) {
      closing[i] = PairByDirection(approach.directions[i], FilterDirections(relation, kMotions[i]));
      opening[i] = Transposed(closing[i]);
    }
    const int lost = dimensions_ ? dimensions_->first - dimensions_->second : 0;
    const Passage into{lost, false, open, closed, closing}, out{lost, true, closed, open, opening};
    Add(into);
    Add(out);
    if (lost == 0) return;
    TryLaws(into, open.singular);
    TryLaws(out, open.singular);
  }

  void Count(const Passage& passage, Measure measure, int motion = 0, int from = 0, int to = 0) {
    Tally& tally = count_.tallies[{measure, passage.lost_dimensions, passage.opens, motion, from, to}];
    if (tally.count++ == 0) tally.first = place_;
  }

  void Add(const Passage& passage) {
    Count(passage, Measure::kTransitions, 0, passage.before.singular, passage.after.singular);
    if (dimensions_) {
      const auto [open, closed] = *dimensions_;
      Count(passage, Measure::kDimensions, 0, passage.opens ? closed : open, passage.opens ? open : closed);
    }
    const algebra::Transition analysis = AnalyzeTransition(passage.before, passage.after);
    const auto forced = ForcedDofTransitions(passage.before, passage.after);
    AddKinds(passage, analysis.dof_transitions, forced);
    if (analysis.dof_transitions.empty()) {
      Count(passage, Measure::kSameDofs);
      return;
    }
    AddRules(passage, analysis);
  }

  void AddKinds(const Passage& passage, const std::vector<DofTransition>& all_pairs,
                const std::vector<DofTransition>& forced) {
    for (int motion = 0; motion < 2; ++motion) {
      for (int from = 0; from < kDofIndices; ++from) {
        for (int to = 0; to < kDofIndices; ++to) {
          if (from == to) continue;
          const DofTransition kind{kMotions[motion], static_cast<DofIndex>(from), static_cast<DofIndex>(to)};
          const bool real = passage.pairings[motion][from][to] != 0, counted = Contains(all_pairs, kind);
          if (real) Count(passage, Measure::kByDirection, motion, from, to);
          if (Contains(forced, kind)) Count(passage, Measure::kForced, motion, from, to);
          if (counted) Count(passage, Measure::kAllPairs, motion, from, to);
          if (counted && !real) Count(passage, Measure::kOnlyByCounts, motion, from, to);
          if (real && !counted) Count(passage, Measure::kHidden, motion, from, to);
        }
      }
    }
  }

  void AddRules(const Passage& passage, const algebra::Transition& analysis) {
    int named = 0;
    bool makes = false, detaches = false;
    for (const SubSkill skill : analysis.sub_skills) {
      named |= 1 << static_cast<int>(skill);
      makes = makes || skill == SubSkill::kMakeContactInTranslation ||
              skill == SubSkill::kType1MakeContactInRotation ||
              skill == SubSkill::kType2MakeContactInRotation;
      detaches = detaches || skill == SubSkill::kDetachContactInTranslation ||
                 skill == SubSkill::kDetachContactInRotation;
    }
    Count(passage, Measure::kSubSkills, 0,
          (passage.before.singular ? 1 : 0) + (passage.after.singular ? 2 : 0), named);
    if (makes && detaches) Count(passage, Measure::kMakeAndDetach);
    if (analysis.critical) Count(passage, Measure::kCritical);
    if (analysis.ambiguous) Count(passage, Measure::kAmbiguous);
  }

  void Try(int law, const Passage& passage, bool holds) {
    Count(passage, Measure::kLawTried, 0, law);
    if (!holds) Count(passage, Measure::kLawBroken, 0, law);
  }

  // The laws of TransitionLaws() in their order; `kept_singular`: the relation that the motion keeps is.
  void TryLaws(const Passage& passage, bool kept_singular) {
    using enum DofIndex;
    const bool from_singular = passage.before.singular, to_singular = passage.after.singular;
    if (!passage.opens && !from_singular && !to_singular) {
      Try(0, passage, !AnyDirection(passage, [](DofIndex from, DofIndex to) {
            return from != kMaintaining || to != kDetaching;
          }));
    }
    if (!passage.opens && !from_singular && to_singular) {
      Try(1, passage, !AnyDirection(passage, [](DofIndex from, DofIndex to) {
            return to == kSingularConstraining && from != kConstraining;
          }));
    }
    if (AnyDirection(passage, [](DofIndex from, DofIndex to) {
          return from >= kSingularMaintaining && to >= kSingularMaintaining;
        })) {
      Try(2, passage, kept_singular);
    }
    if (Rises(passage)) Try(3, passage, from_singular);
  }

  const SolidPair& pair_;
  size_t unit_;
  TransitionPlace place_;                          // of the neighbours at hand
  std::optional<std::pair<int, int>> dimensions_;  // of the open and the closed formation, of a translation
  algebra::MotionDofEngine engine_;
  TransitionCount count_;
};

}  // namespace

uint64_t TransitionCount::Count(const TallyKey& key) const {
  const auto at = tallies.find(key);
  return at == tallies.end() ? 0 : at->second.count;
}

const std::vector<TransitionLaw>& TransitionLaws() {
  static const std::vector<TransitionLaw> laws = {
      {"non-singular",
       "Between non-singular relations, closing, only maintaining directions change, to detaching ones."},
      {"into-singular",
       "From a non-singular relation into a singular one, no maintaining or detaching direction becomes "
       "singular constraining."},
      {"singular-kept",
       "A direction goes from one singular kind to another only along a motion that keeps a "
       "singular contact."},
      {"constraint-rises", "A constraining DOF rises only where a singular relation is left."}};
  return laws;
}

TransitionCount CountTransitions(const SolidPair& pair, size_t unit) { return Counter(pair, unit).Run(); }

void Merge(TransitionCount* total, const TransitionCount& part) {
  total->pairs += part.pairs;
  total->cells += part.cells;
  total->formations += part.formations;
  total->uneven_formations += part.uneven_formations;
  total->borders += part.borders;
  total->tilts += part.tilts;
  total->undecided_tilts += part.undecided_tilts;
  for (const auto& [key, tally] : part.tallies) {
    Tally& sum = total->tallies[key];
    if (sum.count == 0 || tally.first.unit < sum.first.unit) sum.first = tally.first;
    sum.count += tally.count;
  }
}

PlacePoses PosesOf(const TransitionPlace& place) {
  const algebra::Pose border{{}, place.border};
  if (!place.turn) return {border, {{}, place.open}};
  return {border, TurnedPose(place.border, *place.turn)};
}

}  // namespace tact::enumerators
