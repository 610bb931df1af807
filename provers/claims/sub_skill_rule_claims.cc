#include <algorithm>
#include <optional>

#include "algebra/contact/dof_pairing.h"
#include "algebra/error.h"
#include "enumerators/dof_transition_scenes.h"
#include "enumerators/neighbour_relations.h"
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

// The rules of 2.6, read by the counts of DOFs and by the directions of motion.

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
  const algebra::Scene scene = enumerators::RollIntoTheCorner();
  const algebra::PathContacts path = FollowScene(scene);
  if (path.event) throw InvariantError("the roll is broken: " + path.event->what);
  const ContactRelation &a = path.start.relation, &b = path.end.relation;
  View view;
  view.width = 420;
  outcome.figures = {
      {"A bar rolls on its bottom edge", DrawScene(scene, 0, a, view)},
      {"until its top edge meets the ceiling and its side the wall", DrawScene(scene, 1, b, view)}};
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

std::vector<Claim> SubSkillRuleClaims() {
  std::vector<Claim> claims;
  for (size_t r = 0; r < Rules().size(); ++r) {
    claims.push_back({Rules()[r].id, Rules()[r].statement, Rules()[r].source, "exhaustive",
                      [r](Effort effort) { return TryRule(r, effort); }});
  }
  return claims;
}

}  // namespace tact::provers
