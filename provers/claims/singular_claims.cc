#include <algorithm>

#include "algebra/exact/linear_algebra.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/definitions.h"
#include "provers/claims/dof_laws.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;

// Two parallel convex edges in contact along y, as in Fig. 2.17: the planes are the fixed block's top and side.
ContactRelation ParallelEdges() {
  const std::vector<algebra::Vector3> planes = {{0, 0, 1}, {1, 0, 0}};
  return {{{{0, -1, 0}, planes, "one end of the edge"}, {{0, 1, 0}, planes, "the other end"}}};
}

size_t WorldSize(Effort effort) {
  return effort == Effort::kQuick ? 2 : (effort == Effort::kStandard ? 3 : 4);
}

Outcome TrySingularSums(Effort effort) {
  return LawsHoldThroughout(enumerators::SingularWorld(WorldSize(effort)), "thesis.2.2.2.sums", SumLaws(),
                            "The singular DOFs are those of what is left when the singular contacts are "
                            "taken away (2.8), so they add up as any "
                            "relation's do.");
}

Outcome TryFootnoteSingular(Effort effort) {
  const std::string id = "thesis.2.6.footnote-singular";
  // With fewer than three contacts there is no counterexample.
  const Census census = TakeCensus(enumerators::SingularWorld(std::max<size_t>(3, WorldSize(effort))));
  const auto equal = RestrictedLaws("zero"), unequal = RestrictedLaws("nonzero");
  const CensusClass* differs =
      SmallestClass(census, [&](const MotionDof& dof) { return dof.singular && Holds(unequal[0], dof); });
  const CensusClass* agrees = SmallestClass(census, [&](const MotionDof& dof) {
    return dof.singular && Holds(equal[0], dof) && Holds(equal[1], dof) && Holds(equal[2], dof);
  });
  Outcome outcome;
  if (differs == nullptr || agrees == nullptr) return outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "smallest counterexample within " + census.world.sentence;
  outcome.certificates = {MotionDofCertificate(id + ".equal", id, agrees->witness, equal),
                          MotionDofCertificate(id + ".unequal", id, differs->witness, {unequal[0]})};
  outcome.tables = {{"Equal in all three motions, and not equal in translation",
                     DofHeader(),
                     {DofCells(agrees->dof), DofCells(differs->dof)}}};
  outcome.evidence = "Read as a statement on every singular relation it fails. Smallest counterexample: " +
                     Describe(agrees->witness) +
                     ". The singular contact's planes lie in the span of what the other contacts say "
                     "already, and the restricted DOFs are the sums "
                     "after all.\n\n"
                     "Read as 'not always equal' it is true: " +
                     Describe(differs->witness) +
                     " has restricted DOFs without any detaching or constraining one. What does hold is an "
                     "inequality: the planes of the "
                     "non-singular contacts are among all planes, so each restricted DOF in translation and "
                     "in all motion is at least the sum "
                     "(thesis.2.6.footnote-inequality).";
  return outcome;
}

Outcome TryFootnoteInequality(Effort effort) {
  return LawsHoldThroughout(enumerators::SingularWorld(WorldSize(effort)), "thesis.2.6.footnote-inequality",
                            RestrictedLaws("nonnegative"),
                            "In translation and in all motion because fewer planes cannot have more rank. In "
                            "rotation r_a - r_t is the number of "
                            "axis directions that no motion keeping every contact has, and more planes leave "
                            "no more such motions.");
}

Outcome TryRestrictedRotation(Effort effort) {
  Outcome outcome =
      HoldsThroughout(enumerators::SingularWorld(WorldSize(effort)), "thesis.2.6.restricted-rotation",
                      [](const ContactRelation& relation, const MotionDof& dof) {
                        const auto motions = NullSpace(LegalRows(relation));
                        std::vector<algebra::IntegerVector> axes;
                        for (size_t i = 0; i < motions.rows; ++i) {
                          const auto v = motions.RowVector(i);
                          axes.push_back({v[0], v[1], v[2]});
                        }
                        const auto kept = Rank(algebra::IntegerMatrix::FromRows(axes, 3));
                        return dof.rotation.restricted == 3 - static_cast<int>(kept);
                      });
  outcome.evidence =
      "The motions on which every plane of every contact vanishes are computed, their axis directions "
      "ranked, and the rank is "
      "held against 3 - r_r." +
      (outcome.evidence.empty() ? "" : "\n\n" + outcome.evidence);
  return outcome;
}

Outcome TryThirdRule(Effort) {
  const std::string id = "thesis.2.6.third-rule";
  const ContactRelation relation = ParallelEdges();
  const MotionDof dof = ComputeMotionDof(relation);
  // All three translations count as singular maintaining, though only 3 - r_t of them keep the contact.
  const Assertion overcounts{
      {{"translation.maintaining", 1}, {"translation.restricted", 1}, {"constant", -3}}, "positive"};
  Outcome outcome;
  outcome.verdict = Holds(overcounts, dof) ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "the example of Fig. 2.17";
  outcome.tables = {{"Parallel edges in contact", DofHeader(), {DofCells(dof)}}};
  outcome.certificates = {MotionDofCertificate(id + ".figure-2.17", id, relation, {overcounts})};
  outcome.evidence = "Two parallel edges: " + Describe(relation) +
                     ". The singular maintaining DOF in translation is three, the restricted DOF two: of the "
                     "three directions only the one along the "
                     "edge keeps the contact. A rule that looks at singular maintaining DOFs alone takes all "
                     "three for sliding.";
  return outcome;
}

Outcome TryAccompanied(Effort) {
  const std::string id = "thesis.2.4.2.accompanied";
  const ContactRelation nothing;
  const ContactRelation edges = ParallelEdges();
  const auto transition = AnalyzeTransition(ComputeMotionDof(nothing), ComputeMotionDof(edges));
  Outcome outcome;
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "smallest counterexample: from no contact to one singular contact primitive";
  outcome.certificates = {TransitionsCertificate(id + ".counterexample", id,
                                                 {{"nothing touches", nothing}, {"parallel edges", edges}},
                                                 {{0,
                                                   {{"translation.maintaining", -3},
                                                    {"translation.singular_maintaining", 3},
                                                    {"translation.detaching", 0},
                                                    {"translation.restricted", 2}}}})};
  std::string skills;
  for (const auto skill : transition.sub_skills) skills += (skills.empty() ? "" : ", ") + ToString(skill);
  outcome.numbers = {{"DOF-transitions from detaching", 0}};
  for (const auto& t : transition.dof_transitions) {
    outcome.numbers[0].second += t.from == algebra::DofIndex::kDetaching ? 1 : 0;
  }
  outcome.evidence =
      "Bring one edge from free space onto another, parallel one: the maintaining DOF in translation falls "
      "from 3 to 0, the singular "
      "maintaining DOF rises from 0 to 3, and no detaching DOF changes, for there was none. The restricted "
      "DOF rises too, so the rule of 2.6 selects " +
      skills +
      " where there is nothing to slide on.\n\n"
      "Corrected: a singular relation reached from one with contacts loses their detaching DOFs; so the "
      "statement holds for "
      "transitions from a non-singular relation whose detaching DOF in translation is not zero, and a slide "
      "should be selected only there. Reached "
      "from free space, or from a relation that only constrains, no detaching DOF is lost.";
  return outcome;
}

}  // namespace

std::vector<Claim> SingularClaims() {
  return {
      {"thesis.2.2.2.sums", "The singular motion DOFs in translation and in rotation each add up to three.",
       "2.2.2 and 2.3.1", "exhaustive", TrySingularSums},
      {"thesis.2.4.2.accompanied",
       "A DOF-transition from maintaining to singular maintaining is always accompanied by one from "
       "detaching to singular "
       "maintaining in translation.",
       "2.4.2", "exhaustive", TryAccompanied},
      {"thesis.2.6.third-rule",
       "Selecting a slide whenever a maintaining DOF becomes a singular maintaining one is not correct.",
       "2.6, Fig. 2.17", "symbolic", TryThirdRule},
      {"thesis.2.6.restricted-rotation",
       "The restricted DOF in rotation is r_r = r_a - r_t: the axis directions that no motion keeping the "
       "contact relation has.",
       "2.6", "exhaustive", TryRestrictedRotation},
      {"thesis.2.6.footnote-singular",
       "In a singular relation a restricted DOF is not equal to the sum of the singular detaching and "
       "singular constraining DOFs.",
       "2.6, footnote 1", "exhaustive", TryFootnoteSingular},
      {"thesis.2.6.footnote-inequality",
       "In a singular relation a restricted DOF is at least the sum of the singular detaching and singular "
       "constraining DOFs.",
       "2.6, footnote 1, corrected", "exhaustive", TryFootnoteInequality}};
}

}  // namespace tact::provers
