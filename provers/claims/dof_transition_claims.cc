#include <algorithm>
#include <optional>
#include <set>

#include "algebra/contact/dof_pairing.h"
#include "algebra/error.h"
#include "enumerators/dof_census.h"
#include "enumerators/neighbour_relations.h"
#include "enumerators/translation_steps.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/dof_transition_scenes.h"
#include "provers/path_certificate.h"
#include "provers/report/solid_drawing.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::DofIndex;
using algebra::DofTransition;
using algebra::Motion;
using algebra::MotionDof;

std::string Name(DofIndex index) {
  static const char* const kNames[] = {"M", "D", "C", "SM", "SD", "SC"};
  return kNames[static_cast<int>(index)];
}

std::string Pair(DofIndex a, DofIndex b) { return Name(a) + " - " + Name(b); }

bool Contains(const std::vector<DofTransition>& list, const DofTransition& t) {
  return std::find(list.begin(), list.end(), t) != list.end();
}

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

std::vector<DrawnSolid> Draw(const algebra::Scene& scene, const algebra::Rational& s) {
  return {{algebra::UnionOfHulls(scene.fixed_pieces), Part::kFixed},
          {Transform(algebra::UnionOfHulls(scene.moving_pieces), scene.path.At(s)), Part::kMoving}};
}

Outcome TryAllThirty(Effort) {
  const std::string id = "thesis.2.3.1.all-30-appear";
  Outcome outcome;
  Table table{
      "Fifteen motions, each read forwards and backwards",
      {"pair", "what moves", "m d c before, in translation and in rotation", "after", "forced by the counts"},
      {}};
  std::set<DofTransition> seen;
  for (const DofTransitionScene& scene : DofTransitionScenes()) {
    const algebra::PathContacts path = FollowScene(scene.scene);
    if (path.event) {
      outcome.evidence =
          "The motion of " + Pair(scene.before, scene.after) + " is broken: " + path.event->what;
      return outcome;
    }
    const ContactRelation &a = path.start.relation, &b = path.end.relation;
    const auto by_direction = DofTransitionsByDirection(a, b), back = DofTransitionsByDirection(b, a);
    const auto forced = ForcedDofTransitions(ComputeMotionDof(a), ComputeMotionDof(b));
    seen.insert(by_direction.begin(), by_direction.end());
    seen.insert(back.begin(), back.end());
    std::string where;
    for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
      if (Contains(forced, {motion, scene.before, scene.after}))
        where += (where.empty() ? "" : ", ") + ToString(motion);
    }
    const auto cells = [](const ContactRelation& r) {
      const MotionDof d = ComputeMotionDof(r);
      const auto three = [](const auto& m) {
        return std::to_string(m.maintaining) + " " + std::to_string(m.detaching) + " " +
               std::to_string(m.constraining);
      };
      return (d.singular ? "s " : "") + three(d.translation) + ", " + three(d.rotation);
    };
    table.rows.push_back(
        {Pair(scene.before, scene.after), scene.story, cells(a), cells(b), where.empty() ? "no" : where});
    View view;
    view.width = 420;
    outcome.figures.push_back(
        {Pair(scene.before, scene.after) + ": before", DrawContactRelation(Draw(scene.scene, 0), a, view)});
    outcome.figures.push_back({scene.story, DrawContactRelation(Draw(scene.scene, 1), b, view)});
    for (const PathDirection way : {PathDirection::kForth, PathDirection::kBack}) {
      const bool forth = way == PathDirection::kForth;
      const std::string name =
          Name(forth ? scene.before : scene.after) + "-" + Name(forth ? scene.after : scene.before);
      outcome.certificates.push_back(PathCertificate(id + "." + name, id, scene.scene, way));
    }
  }
  outcome.verdict = seen.size() == 60 ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "complete";
  outcome.numbers = {
      {"kinds in translation and in rotation that occur", static_cast<long long>(seen.size())}};
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
  for (const DofTransitionScene& scene : DofTransitionScenes()) {
    const DofTransition t{Motion::kTranslation, scene.before, scene.after};
    const bool straight = scene.scene.path.kind == algebra::MotionPath::Kind::kLine;
    const bool keeps_singular = scene.before >= DofIndex::kSingularMaintaining;
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

// ---- 2.6: the rules, read by counts and by direction

struct Rule {
  std::string id, statement, source;
  bool (*names)(const DofTransition& t);
  std::string about;
  std::string more = {};  // what else is to be said
};

struct Example {
  ContactRelation before, after;
  size_t contacts = 0;
};

struct Trial {
  long long pairs = 0, named = 0, by_direction = 0, without_reason = 0, missed = 0;
  std::optional<Example> smallest_without_reason, smallest_missed;

  void Keep(std::optional<Example>& smallest, const ContactRelation& a, const ContactRelation& b) {
    const size_t contacts = a.contacts.size() + b.contacts.size();
    if (!smallest || contacts < smallest->contacts) smallest = Example{a, b, contacts};
  }

  void Add(const Rule& rule, const ContactRelation& a, const ContactRelation& b,
           const std::vector<DofTransition>& by_counts, const std::vector<DofTransition>& directions) {
    for (const Motion motion : {Motion::kTranslation, Motion::kRotation}) {
      const auto any = [&](const std::vector<DofTransition>& list) {
        return std::any_of(list.begin(), list.end(),
                           [&](const DofTransition& t) { return t.motion == motion && rule.names(t); });
      };
      const bool literal = any(by_counts), real = any(directions);
      ++pairs;
      named += literal ? 1 : 0;
      by_direction += real ? 1 : 0;
      if (literal && !real) {
        ++without_reason;
        Keep(smallest_without_reason, a, b);
      }
      if (real && !literal) {
        ++missed;
        Keep(smallest_missed, a, b);
      }
    }
  }
};

// Both ways between every relation of the worlds and the relations before it.
std::vector<Trial> TryRules(const std::vector<Rule>& rules, Effort effort) {
  std::vector<Trial> trials(rules.size());
  algebra::MotionDofEngine engine;
  const auto step = [&](const ContactRelation& a, const MotionDof& before, const ContactRelation& b,
                        const MotionDof& after) {
    const auto counts = DofTransitionsByCounts(before, after), directions = DofTransitionsByDirection(a, b);
    for (size_t r = 0; r < rules.size(); ++r) trials[r].Add(rules[r], a, b, counts, directions);
  };
  const auto world = [&](const enumerators::ContactWorld& relations) {
    enumerators::ForEachRelation(relations, [&](const ContactRelation& after) {
      for (size_t i = 1; i < after.contacts.size(); ++i) {
        if (after.contacts[i] == after.contacts[i - 1]) return;
      }
      const MotionDof b = engine.Compute(after);
      enumerators::ForEachRelationBefore(after, [&](const ContactRelation& before) {
        const MotionDof a = engine.Compute(before);
        step(before, a, after, b);
        step(after, b, before, a);
      });
    });
  };
  if (effort == Effort::kFull) {
    world(enumerators::SingularWorld(3));
    world(enumerators::CubeWorld(4));
    return trials;
  }
  enumerators::ContactWorld at_origin = enumerators::SingularWorld(3);
  std::erase_if(at_origin.contacts, [](const algebra::Contact& contact) { return !contact.point.IsZero(); });
  world(at_origin);
  world(enumerators::SingularWorld(2));
  world(enumerators::CubeWorld(3));
  return trials;
}

std::string Step(const Example& example) {
  return Describe(example.before) + "; then " + Describe(example.after);
}

const std::vector<Rule>& Rules() {
  using enum DofIndex;
  static const std::vector<Rule> rules = {
      {"thesis.2.3.2.make-contact-rule",
       "A make-contact sub-skill is to be selected just when a maintaining DOF becomes a detaching one, told "
       "by what falls and "
       "what rises.",
       "2.3.2, 2.6, first rule",
       [](const DofTransition& t) { return t.from == kMaintaining && t.to == kDetaching; },
       "maintaining -> detaching"},
      {"thesis.2.3.2.detach-contact-rule",
       "A detach-contact sub-skill is to be selected just when a detaching or singular detaching DOF becomes "
       "a maintaining one, told "
       "by what falls and what rises.",
       "2.3.2, 2.6, second rule",
       [](const DofTransition& t) {
         return (t.from == kDetaching || t.from == kSingularDetaching) && t.to == kMaintaining;
       },
       "(singular) detaching -> maintaining"},
      {"thesis.2.3.2.slide-rule",
       "A maintaining DOF becomes a singular maintaining one, the sign of a slide, just when the one falls "
       "and the other rises.",
       "2.3.2, 2.6, third rule",
       [](const DofTransition& t) { return t.from == kMaintaining && t.to == kSingularMaintaining; },
       "maintaining -> singular maintaining",
       "\n\nThat this is not enough for a slide is another matter: from free space it is an approach "
       "(thesis.2.4.2.accompanied), and "
       "where the restricted DOF does not rise nothing was slid off (thesis.2.6.third-rule)."},
      {"thesis.2.3.2.critical-rule",
       "A transition is critical just when a singular maintaining or singular detaching DOF becomes a "
       "constraining one, told by what "
       "falls and what rises.",
       "2.3.2, 2.6, critical transitions",
       [](const DofTransition& t) {
         return (t.from == kSingularMaintaining || t.from == kSingularDetaching) && t.to == kConstraining;
       },
       "singular maintaining or detaching -> constraining",
       "\n\nRead by direction the rule is about the right thing: along a straight line, constraint comes up "
       "only where a "
       "singular relation is "
       "left (Theorem 3 of docs/dof-transitions.md), by singular maintaining, detaching or constraining -> "
       "constraining. The third "
       "is not critical: its directions were blocked before, so no error can arise in them."}};
  return rules;
}

const std::vector<Trial>& TrialsOfRules(Effort effort) {
  static const std::vector<Trial> small = TryRules(Rules(), Effort::kStandard);
  if (effort != Effort::kFull) return small;
  static const std::vector<Trial> large = TryRules(Rules(), Effort::kFull);
  return large;
}

// The step with real solids in which the first rule misses a make-contact.
void AddRoll(Outcome& outcome, const std::string& id) {
  const algebra::Scene scene = RollIntoTheCorner();
  const algebra::PathContacts path = FollowScene(scene);
  if (path.event) throw InvariantError("the roll is broken: " + path.event->what);
  const ContactRelation &a = path.start.relation, &b = path.end.relation;
  View view;
  view.width = 420;
  outcome.figures = {{"A bar rolls on its bottom edge", DrawContactRelation(Draw(scene, 0), a, view)},
                     {"until its top edge meets the ceiling and its side the wall",
                      DrawContactRelation(Draw(scene, 1), b, view)}};
  outcome.certificates.push_back(PathCertificate(id + ".roll", id, scene));
  const algebra::Transition literal = AnalyzeTransition(ComputeMotionDof(a), ComputeMotionDof(b));
  outcome.evidence +=
      "\n\nWith real solids: a bar rolls on its bottom edge until its top edge meets the ceiling and its "
      "side a wall, both at "
      "once. Across, a maintaining direction becomes detaching; upright, a detaching one constraining. The "
      "counts, 2 1 0 to "
      "1 1 1 in translation, show maintaining -> constraining instead; " +
      std::string(literal.practical ? "" : "so the transition counts as impractical, and ") +
      "no make-contact in translation is named though the bar meets two faces.";
}

Outcome TryRule(size_t r, Effort effort) {
  const Rule& rule = Rules()[r];
  const Trial& trial = TrialsOfRules(effort)[r];
  Outcome outcome;
  outcome.verdict = trial.without_reason + trial.missed == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.bound = std::string(effort == Effort::kFull ? "all relations of up to 3 contacts with singular "
                                                        "ones at four points, of up to 4 ordinary ones "
                                                      : "all relations of up to 3 contacts with singular "
                                                        "ones at one point, of up to 2 at four points, of "
                                                        "up to 3 ordinary ones ") +
                  "at a cube's corners, and the relations before them, both ways";
  outcome.numbers = {{"steps, motions apart", trial.pairs},
                     {"the counts allow " + rule.about, trial.named},
                     {"some direction goes so", trial.by_direction},
                     {"named without such a direction", trial.without_reason},
                     {"such a direction, but not named", trial.missed}};
  outcome.evidence =
      "Literally, a DOF-transition is any pair of an index that falls and one that rises. Held against it: "
      "whether "
      "some direction of motion really goes " +
      rule.about + " (docs/dof-transitions.md).";
  const auto add = [&](const std::optional<Example>& example, const std::string& name,
                       const std::string& prose) {
    if (!example) return;
    outcome.evidence += "\n\n" + prose + ": " + Step(*example) + ".";
    outcome.certificates.push_back(TransitionsCertificate(
        rule.id + "." + name, rule.id, {{"before", example->before}, {"after", example->after}}, {}));
  };
  add(trial.smallest_without_reason, "without-reason",
      "Smallest step where the counts name it and no direction does");
  add(trial.smallest_missed, "missed", "Smallest step where a direction goes so and the counts hide it");
  if (r == 0) AddRoll(outcome, rule.id);
  outcome.evidence += rule.more;
  if (outcome.verdict == Verdict::kRefuted) {
    outcome.evidence +=
        "\n\nCorrected: pair by direction. Where only one index falls or only one rises, nothing changes; "
        "elsewhere the directions say which became which.";
  } else {
    outcome.evidence += "\n\nThe counts and the directions agree in every step tried.";
  }
  return outcome;
}

}  // namespace

std::vector<Claim> DofTransitionClaims() {
  std::vector<Claim> claims = {
      {"thesis.2.3.transitions-13", "Between the ten kinds there are 13 kinds of transitions.", "2.3",
       "exhaustive", TryThirteen},
      {"thesis.2.3.1.all-30-appear", "Theoretically all 30 kinds of DOF-transitions appear.", "2.3.1",
       "symbolic", TryAllThirty},
      {"thesis.2.3.1.practical-20",
       "The ten impractical kinds are told from the twenty practical ones by the motions they need.",
       "2.3.1, Fig. 2.5", "symbolic", TryTwenty},
      {"thesis.2.3.1.one-contact",
       "One added contact never turns a maintaining DOF into a constraining one, and lowers the maintaining "
       "DOF of one motion at "
       "most, by one.",
       "2.3.1, Fig. 2.4", "exhaustive", TryOneContact}};
  for (size_t r = 0; r < Rules().size(); ++r) {
    claims.push_back({Rules()[r].id, Rules()[r].statement, Rules()[r].source, "exhaustive",
                      [r](Effort effort) { return TryRule(r, effort); }});
  }
  return claims;
}

}  // namespace tact::provers
