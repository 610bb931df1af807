#include <array>
#include <map>

#include "algebra/contact/dof_transition.h"
#include "provers/claims/transition_counting.h"

namespace tact::provers {
namespace {

using enumerators::Measure;
using enumerators::TallyKey;
using enumerators::TransitionPlace;

std::string SkillNames(int named) {
  std::string text;
  for (int i = 0; i < 7; ++i) {
    if ((named >> i & 1) == 0) continue;
    text += (text.empty() ? "" : ", ") + ToString(static_cast<algebra::SubSkill>(i));
  }
  return text.empty() ? "none" : text;
}

// Make-contact, detach-contact, slide: one act, in one motion or in both.
int ActsOf(int named) {
  const auto has = [named](algebra::SubSkill skill) { return (named >> static_cast<int>(skill) & 1) != 0; };
  using enum algebra::SubSkill;
  return (has(kMakeContactInTranslation) || has(kType1MakeContactInRotation) ||
                  has(kType2MakeContactInRotation)
              ? 1
              : 0) +
         (has(kDetachContactInTranslation) || has(kDetachContactInRotation) ? 1 : 0) +
         (has(kSlideInTranslation) || has(kSlideInRotation) ? 1 : 0);
}

Outcome TryRulesDecide(Effort effort) {
  const CountedFamilies& counted = FamiliesFor(effort);
  const std::string id = "thesis.2.6.rules-decide";
  Outcome outcome;
  outcome.bound = BoundOf(counted);
  // [closing, opening][acts].
  std::array<std::array<uint64_t, 4>, 2> acts{};
  std::array<std::array<std::optional<CountedPlace>, 4>, 2> first;
  std::array<uint64_t, 4> unnamed{};  // closing, no act: by whether the relation is singular before, after
  std::map<int, std::array<std::array<uint64_t, 2>, 2>> by_names;  // [closing, opening][translation, tilt]
  for (const auto& [key, tally] : counted.total.tallies) {
    if (key.measure != Measure::kSubSkills) continue;
    const size_t way = key.opens ? 1 : 0, number = static_cast<size_t>(ActsOf(key.to));
    acts[way][number] += tally.count;
    by_names[key.to][way][key.lost_dimensions == 0 ? 1 : 0] += tally.count;
    if (way == 0 && number == 0) unnamed[static_cast<size_t>(key.from)] += tally.count;
    auto& place = first[way][number];
    const auto rank = [](const TallyKey& k, const TransitionPlace& p) {
      return std::pair(k.lost_dimensions == 0, p.unit);
    };
    if (!place || rank(key, tally.first) < rank(place->first, place->second)) place = {key, tally.first};
  }
  Table names{"What the rules name where some motion DOF changes",
              {"sub-skills", "closing, straight", "closing, tilt", "opening, straight", "opening, tilt"},
              {}};
  for (const auto& [named, n] : by_names)
    names.rows.push_back(
        {SkillNames(named), Digits(n[0][0]), Digits(n[0][1]), Digits(n[1][0]), Digits(n[1][1])});
  Table numbers{"Acts named: make-contact, detach-contact, slide", {"", "none", "one", "two", "three"}, {}};
  for (const size_t way : {size_t{0}, size_t{1}}) {
    auto& row = numbers.rows.emplace_back();
    row = {way == 0 ? "closing" : "opening"};
    const uint64_t all = acts[way][0] + acts[way][1] + acts[way][2] + acts[way][3];
    for (const uint64_t n : acts[way]) row.push_back(Digits(n) + " (" + Share(n, all) + ")");
  }
  outcome.tables = {std::move(numbers), std::move(names)};
  const uint64_t none = acts[0][0] + acts[1][0], one = acts[0][1] + acts[1][1];
  const uint64_t more = acts[0][2] + acts[0][3] + acts[1][2] + acts[1][3];
  uint64_t same = 0, ambiguous = 0, critical = 0;
  for (const bool opens : {false, true}) {
    same += Sum(counted.total, Measure::kSameDofs, opens, 0, 0, 0);
    ambiguous += Sum(counted.total, Measure::kAmbiguous, opens, 0, 0, 0);
    critical += Sum(counted.total, Measure::kCritical, opens, 0, 0, 0);
  }
  const uint64_t closing_critical = Sum(counted.total, Measure::kCritical, false, 0, 0, 0);
  uint64_t misnamed = 0;  // detach-contact, though more comes into contact
  for (const auto& [named, n] : by_names) {
    const bool detaches =
        (named >> static_cast<int>(algebra::SubSkill::kDetachContactInTranslation) & 1) != 0 ||
        (named >> static_cast<int>(algebra::SubSkill::kDetachContactInRotation) & 1) != 0;
    if (detaches) misnamed += n[0][0] + n[0][1];
  }
  outcome.numbers = {{"detach-contact named, though more touches", static_cast<long long>(misnamed)},
                     {"no act named", static_cast<long long>(none)},
                     {"one act named", static_cast<long long>(one)},
                     {"two acts or more named", static_cast<long long>(more)},
                     {"make-contact and detach-contact named",
                      static_cast<long long>(Sum(counted.total, Measure::kMakeAndDetach, false, 0, 0, 0) +
                                             Sum(counted.total, Measure::kMakeAndDetach, true, 0, 0, 0))},
                     {"several fall and several rise", static_cast<long long>(ambiguous)},
                     {"critical", static_cast<long long>(critical)},
                     {"critical, closing", static_cast<long long>(closing_critical)},
                     {"no motion DOF changes", static_cast<long long>(same)}};
  outcome.verdict = none + more == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  const auto example = [&](size_t way, size_t number, const std::string& name, const std::string& caption) {
    if (first[way][number]) AddExample(counted, id, name, caption, *first[way][number], &outcome);
  };
  example(0, 0, "closing-none", "More comes into contact, and no sub-skill is named");
  example(1, 0, "opening-none", "Contacts open, and no sub-skill is named");
  example(0, 1, "closing-one", "One act is named");
  for (const size_t way : {size_t{0}, size_t{1}}) {
    for (const size_t number : {size_t{2}, size_t{3}})
      example(way, number, "two-" + std::to_string(2 * way + number), "Several acts are named");
  }
  outcome.evidence =
      "For every transition in which a motion DOF changes, the rules of 2.6 were asked, literally. "
      "Make-contact in "
      "translation, in rotation of Type I and of Type II count as one act, and so do the two ways to detach "
      "and to "
      "slide.\n\n" +
      std::string(more == 0 ? "Never do the rules name two acts that differ"
                            : "In " + Digits(more) + " transitions the rules name two acts or more") +
      "; they name none in " + Digits(none) + " of " + Digits(none + one + more) +
      " transitions. Backwards that is meant: leaving a singular relation counts as part of the next "
      "sub-skill (2.4.4). "
      "But forwards, " +
      Digits(acts[0][0]) +
      " transitions bring more into contact and are named by no rule: from singular relations " +
      Digits(unnamed[1]) + " into non-singular ones, as when an edge on an edge is laid down flush, and " +
      Digits(unnamed[3]) +
      " into singular ones, as when a part runs along an edge and meets a wall; from "
      "non-singular ones " +
      Digits(unnamed[0] + unnamed[2]) +
      ". What a robot does to bring more into contact is a make-contact, and no rule says so there. "
      "Corrected: a transition after which more touches, and that no rule names, is a make-contact.\n\nThe "
      "second rule, read by counts, names detach-contact in " +
      Digits(misnamed) +
      " transitions that bring more into contact, most of them where a singular relation's SM and SD become "
      "M and "
      "D: by direction SD becomes D there, not M. Corrected: pair by direction.\n\nSeveral indices fall and "
      "several rise in " +
      Digits(ambiguous) +
      " transitions; there the text does not say which became which, and only the directions do "
      "(thesis.2.3.2.make-contact-rule and the claims after it).\n\nCritical are " +
      Digits(critical) + " transitions, " + Digits(closing_critical) +
      " of them closing: the narrow entrance is passed when rims are left for the walls, where fewer "
      "elements touch.";
  return outcome;
}

}  // namespace

Claim RulesDecideClaim() {
  return {"thesis.2.6.rules-decide", "For every change of motion DOFs the rules name one sub-skill.", "2.6",
          "exhaustive", TryRulesDecide};
}

}  // namespace tact::provers
