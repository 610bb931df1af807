#include <algorithm>
#include <optional>
#include <set>

#include "enumerators/shown_transitions.h"
#include "enumerators/translation_steps.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/path_certificate.h"
#include "provers/report/scene_drawing.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::DofIndex;
using algebra::DofTransition;
using algebra::Motion;
using algebra::MotionDof;

using enumerators::ShownScene;

std::string Pair(DofIndex a, DofIndex b) { return enumerators::Symbol(a) + " - " + enumerators::Symbol(b); }

// ---- 2.3: thirteen transitions

std::string KindText(const enumerators::TranslationKind& kind) {
  return std::to_string(kind[0]) + " " + std::to_string(kind[1]) + " " + std::to_string(kind[2]);
}

Outcome TryThirteen(Effort effort) {
  const auto definitions = enumerators::TranslationSteps(effort == Effort::kFull ? 5 : 4);
  Outcome outcome;
  Table counts{"Pairs of kinds, by what counts as a step", {"a step", "pairs"}, {}};
  Table list{"The thirteen", {"m d c before", "m d c after"}, {}};
  size_t thirteens = 0;
  for (const auto& definition : definitions) {
    counts.rows.push_back({definition.name, std::to_string(definition.steps.size())});
    if (definition.steps.size() != 13) continue;
    ++thirteens;
    for (const auto& [before, after] : definition.steps)
      list.rows.push_back({KindText(before), KindText(after)});
  }
  outcome.verdict = thirteens == 1 ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound =
      "all sets of at most four of the 26 normals with entries -1, 0, 1; more normals add no step";
  outcome.numbers = {{"one contact", static_cast<long long>(definitions.front().steps.size())},
                     {"any contacts", static_cast<long long>(definitions.back().steps.size())}};
  outcome.tables = {std::move(counts), std::move(list)};
  outcome.evidence =
      "Thirteen comes out if a step is what a translation that keeps the contacts so far can bring about by "
      "one more contact, "
      "or by the two walls of a slot. Of the 16 steps that one contact makes, six are left out then: where "
      "no translation "
      "keeps the contacts, detaching DOFs can become constraining by turning only; and three come in: a free "
      "direction that "
      "a slot blocks at once. Whether Ikeuchi and Suehiro meant this cannot be read off the text; other "
      "readings give 6, 10, 12, "
      "16 or 40 (docs/dof-transitions.md).";
  return outcome;
}

// ---- 2.3.1: the thirty

std::string DofText(const MotionDof& dof) {
  const auto three = [](const auto& m) {
    return std::to_string(m.maintaining) + " " + std::to_string(m.detaching) + " " +
           std::to_string(m.constraining);
  };
  return (dof.singular ? "s " : "") + three(dof.translation) + ", " + three(dof.rotation);
}

std::string ForcedIn(const ShownScene& shown) {
  std::string motions;
  for (const DofTransition& t : shown.forced) {
    if (t.from == shown.given.before && t.to == shown.given.after)
      motions += (motions.empty() ? "" : ", ") + ToString(t.motion);
  }
  return motions.empty() ? "no" : motions;
}

Outcome TryAllThirty(Effort) {
  const std::string id = "thesis.2.3.1.all-30-appear";
  Outcome outcome;
  Table table{
      "Fifteen motions, each read forwards and backwards",
      {"pair", "what moves", "m d c before, in translation and in rotation", "after", "forced by the counts"},
      {}};
  const std::vector<ShownScene> scenes = enumerators::ShowScenes();
  View view;
  view.width = 420;
  for (const ShownScene& shown : scenes) {
    const enumerators::DofTransitionScene& given = shown.given;
    table.rows.push_back({Pair(given.before, given.after), given.story, DofText(shown.dof_before),
                          DofText(shown.dof_after), ForcedIn(shown)});
    outcome.figures.push_back(
        {Pair(given.before, given.after) + ": before", DrawScene(given.scene, 0, shown.before, view)});
    outcome.figures.push_back({given.story, DrawScene(given.scene, 1, shown.after, view)});
    const std::string from = enumerators::Symbol(given.before), to = enumerators::Symbol(given.after);
    outcome.certificates.push_back(
        PathCertificate(id + "." + from + "-" + to, id, given.scene, PathDirection::kForth));
    outcome.certificates.push_back(
        PathCertificate(id + "." + to + "-" + from, id, given.scene, PathDirection::kBack));
  }
  const auto shown = enumerators::ShownTransitions(scenes);
  const auto seen =
      std::count_if(shown.begin(), shown.end(), [](const auto& t) { return t.scene.has_value(); });
  outcome.verdict = seen == 60 ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "complete";
  outcome.numbers = {{"kinds in translation and in rotation that occur", seen}};
  outcome.tables = {std::move(table)};
  outcome.evidence =
      "All thirty occur, in translation and in rotation: fifteen pairs of solids and exact motions (a line, "
      "or a turn about a "
      "fixed axis with a rational tangent of half the angle), on which the same elements touch from the "
      "start until just before "
      "the end. Every one is shown by direction: some direction is of the one kind before and of the other "
      "after. All but D - SC "
      "are forced by the counts as well, whichever way one pairs what falls with what rises.";
  return outcome;
}

// ---- 2.3.1: what separates the twenty from the ten

// Ordinary contacts that must change at once (docs/dof-transitions.md, Theorems 1 and 2).
int OrdinaryContacts(DofIndex a, DofIndex b) {
  using enum DofIndex;
  const auto is = [&](DofIndex x, DofIndex y) { return (a == x && b == y) || (a == y && b == x); };
  if (is(kMaintaining, kConstraining) || is(kMaintaining, kSingularConstraining) ||
      is(kConstraining, kSingularMaintaining) || is(kSingularMaintaining, kSingularConstraining)) {
    return 2;
  }
  return is(kMaintaining, kSingularMaintaining) || is(kDetaching, kSingularDetaching) ||
                 is(kConstraining, kSingularConstraining)
             ? 0
             : 1;
}

Outcome TryTwenty(Effort) {
  Outcome outcome;
  Table table{"The fifteen pairs",
              {"pair", "straight motion", "ordinary contacts at once", "keeps a singular contact",
               "practical in Fig. 2.5"},
              {}};
  bool separated = true;
  for (const enumerators::DofTransitionScene& scene : enumerators::DofTransitionScenes()) {
    const DofTransition t{Motion::kTranslation, scene.before, scene.after};
    const bool straight = scene.scene.path.kind == algebra::MotionPath::Kind::kLine;
    const bool keeps_singular =
        scene.before >= DofIndex::kSingularMaintaining && scene.after >= DofIndex::kSingularMaintaining;
    const int contacts = OrdinaryContacts(scene.before, scene.after);
    separated = separated && IsPractical(t) == !(keeps_singular || (!straight && contacts >= 2));
    table.rows.push_back({Pair(scene.before, scene.after), straight ? "yes" : "no", std::to_string(contacts),
                          keeps_singular ? "yes" : "no", IsPractical(t) ? "yes" : "no"});
  }
  outcome.verdict = separated ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "complete";
  outcome.tables = {std::move(table)};
  outcome.no_certificate =
      "the lower bounds are Theorems 2 and 3 of docs/dof-transitions.md; the scenes that reach them are "
      "certified under "
      "thesis.2.3.1.all-30-appear";
  outcome.evidence =
      "The ten impractical kinds are those that keep a singular contact on the way (six) and those that need "
      "both a turn and two "
      "ordinary contacts at one instant (four). Neither alone draws the line of Fig. 2.5: D <-> C and D <-> "
      "SC cannot be had by a "
      "straight motion either, and C <-> SM takes two contacts at once, too, as when both edges of a peg "
      "pass the rims of a slot.\n\n"
      "So 'seldom' is a matter of coincidence: two contacts at one instant happen in parts that are made to "
      "fit. The counts over "
      "families of solids are under thesis.2.3.1.seldom.";
  return outcome;
}

// ---- Theorem 1, on every relation of a world and every contact more

Outcome TryOneContact(Effort effort) {
  const enumerators::ContactWorld world =
      enumerators::CornerWorld(effort == Effort::kQuick ? 3 : (effort == Effort::kStandard ? 4 : 5));
  algebra::MotionDofEngine engine;
  long long steps = 0, failures = 0;
  std::optional<ContactRelation> counterexample;
  enumerators::ForEachRelation(world, [&](const ContactRelation& after) {
    if (after.contacts.empty()) return;
    ContactRelation before = after;
    before.contacts.pop_back();
    const MotionDof a = engine.Compute(before), b = engine.Compute(after);
    const int t = a.translation.maintaining - b.translation.maintaining;
    const int r = a.rotation.maintaining - b.rotation.maintaining;
    const int ct = b.translation.constraining - a.translation.constraining;
    const int cr = b.rotation.constraining - a.rotation.constraining;
    const bool holds = t >= 0 && r >= 0 && t + r <= 1 && ct >= 0 && cr >= 0 &&
                       (t == 0 || (ct == 0 && cr == 0)) && (r == 0 || cr == 0);
    ++steps;
    failures += holds ? 0 : 1;
    if (!holds && !counterexample) counterexample = after;
  });
  Outcome outcome;
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.bound = world.sentence;
  outcome.numbers = {{"steps tried", steps}, {"failures", failures}};
  outcome.evidence =
      "A contact whose normal is new turns one maintaining DOF in translation into a detaching one and "
      "changes nothing in rotation; "
      "one whose normal is not new, but whose row is, does so in rotation; any other turns detaching DOFs "
      "into constraining ones, or "
      "changes nothing. Theorem 1 of docs/dof-transitions.md, proves it for all relations.";
  if (counterexample) outcome.evidence += " Counterexample: " + Describe(*counterexample);
  return outcome;
}

}  // namespace

std::vector<Claim> DofTransitionClaims() {
  return {{"thesis.2.3.transitions-13", "Between the ten kinds there are 13 kinds of transitions.", "2.3",
           "exhaustive", TryThirteen},
          {"thesis.2.3.1.all-30-appear", "Theoretically all 30 kinds of DOF-transitions appear.", "2.3.1",
           "symbolic", TryAllThirty},
          {"thesis.2.3.1.practical-20",
           "The ten impractical kinds are told from the twenty practical ones by the motions they need.",
           "2.3.1, Fig. 2.5", "symbolic", TryTwenty},
          {"thesis.2.3.1.one-contact",
           "One added contact never turns a maintaining DOF into a constraining one, and lowers the "
           "maintaining DOF of one "
           "motion at most, by one.",
           "2.3.1, Fig. 2.4", "exhaustive", TryOneContact}};
}

}  // namespace tact::provers
