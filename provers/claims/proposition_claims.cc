#include <optional>

#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/definitions.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;

Outcome TryProjection(const std::string& id, Effort effort, const std::string& prose,
                      const std::function<bool(const Definitions&, const MotionDof&)>& law) {
  const auto statement = [&](const ContactRelation& relation, const MotionDof& dof) {
    return law(ByDefinition(relation), dof);
  };
  Outcome outcome = HoldsThroughout(enumerators::AxisWorld(ProjectionSize(effort)), id, statement);
  if (outcome.verdict == Verdict::kHoldsTo) {
    // Skew normals meet in other ways than square ones.
    Outcome skew =
        HoldsThroughout(enumerators::DiagonalWorld(effort == Effort::kQuick ? 1 : 2), id, statement);
    skew.bound = outcome.bound + "; " + skew.bound;
    skew.numbers[0].second += outcome.numbers[0].second;
    outcome = std::move(skew);
  }
  outcome.evidence = prose + (outcome.evidence.empty() ? "" : "\n\n" + outcome.evidence);
  return outcome;
}

Outcome TryProposition1(Effort effort) {
  return TryProjection(
      "thesis.2.2.1.proposition-1", effort,
      "V_r, the projection of the legal cone V_a to axis directions, is computed as a cone, generator by "
      "generator, and its "
      "dimension is held against the engine's rank formula c_r = rank A(I_a) - rank N(I_a).\n\n"
      "For all relations: the span of V_a is the null space of the implicit equalities A(I_a), and a "
      "projection's span is the "
      "span's projection; its dimension is (6 - rank A(I_a)) - (3 - rank N(I_a)). V_r is a cone, not the "
      "subspace that the "
      "text calls it.",
      [](const Definitions& d, const MotionDof& dof) {
        return 3 - d.legal_rotation == dof.rotation.constraining;
      });
}

Outcome TryProposition2(Effort effort) {
  return TryProjection(
      "thesis.2.2.1.proposition-2", effort,
      "With d_r read as the axis directions that legal motions add to the maintaining ones, dim V_r - m_r, "
      "both taken from the "
      "projected cones. This is the reading under which the proposition holds; its proof rests on another "
      "(thesis.2.2.1.axis-types).",
      [](const Definitions& d, const MotionDof& dof) {
        return d.legal_rotation - d.maintaining_rotation == dof.rotation.detaching;
      });
}

Outcome TryAxisTypes(Effort effort) {
  const std::string id = "thesis.2.2.1.axis-types";
  const Assertion turns{{{"rotation.maintaining", 1}}, "positive"};
  const Assertion leaves{{{"translation.detaching", 1}}, "positive"};
  std::optional<ContactRelation> witness;
  const auto world = enumerators::AxisWorld(1);
  ForEachRelation(world, [&](const ContactRelation& relation) {
    const MotionDof dof = algebra::ComputeMotionDof(relation);
    if (!witness && Holds(turns, dof) && Holds(leaves, dof)) witness = relation;
  });
  Outcome outcome;
  if (!witness) return outcome;
  const Definitions d = ByDefinition(*witness);
  outcome.verdict = Verdict::kRefuted;
  outcome.bound = "smallest counterexample: one contact (without contacts there is nothing to detach from)";
  outcome.certificates = {MotionDofCertificate(id + ".counterexample", id, *witness, {turns, leaves})};
  outcome.numbers = {{"m_r", d.maintaining_rotation},
                     {"axis directions of detaching motions", d.legal_rotation}};
  outcome.evidence =
      "Counterexample: " + Describe(*witness) +
      ". Its maintaining motions have every axis direction S0. Add a translation that leaves the contact to "
      "any of them: the "
      "motion detaches, with the same S0. So the axis directions of maintaining motions span " +
      std::to_string(d.maintaining_rotation) + " dimensions, those of detaching motions " +
      std::to_string(d.legal_rotation) +
      ", and the sum is not three. Wherever a relation has a maintaining rotation and a detaching "
      "translation this happens.\n\n"
      "Corrected: an axis direction is maintaining if some maintaining motion has it, detaching if it is not "
      "maintaining but some legal motion has it, constraining otherwise. Counted in that order, as "
      "dimensions modulo what came "
      "before, the sum is three (thesis.2.2.1.proposition-2).";
  (void)effort;
  return outcome;
}

Outcome TryProposition3(Effort effort) {
  return TryProjection(
      "thesis.2.2.1.proposition-3", effort,
      "The angular parts of a basis of the maintaining motions are ranked and held against m_a - m_t.\n\n"
      "For all relations: m_t is the dimension of the maintaining motions without angular part, the kernel "
      "of the "
      "projection to angular parts; rank and nullity add up.",
      [](const Definitions& d, const MotionDof& dof) {
        return d.maintaining_rotation == d.maintaining_all - d.maintaining_translation &&
               d.maintaining_rotation == dof.rotation.maintaining;
      });
}

Outcome TryProposition4(Effort effort) {
  const std::string id = "thesis.2.2.1.proposition-4";
  const Census census = TakeCensus(enumerators::AxisWorld(CensusSize(effort)));
  Outcome outcome;
  outcome.bound = "one witness of each type, fewest contacts first";
  for (const int type : {1, 2}) {
    const Assertion occurs{{{"rotation.detaching_type" + std::to_string(type), 1}}, "positive"};
    const CensusClass* smallest =
        SmallestClass(census, [&](const MotionDof& dof) { return Holds(occurs, dof); });
    if (smallest == nullptr) return outcome;
    outcome.evidence += "Type " + std::string(type == 1 ? "I" : "II") + " occurs with " +
                        Describe(smallest->witness) + ".\n\n";
    outcome.certificates.push_back(
        MotionDofCertificate(id + ".type" + std::to_string(type), id, smallest->witness, {occurs}));
  }
  outcome.verdict = Verdict::kProved;
  outcome.evidence +=
      "That there are no others is plain: of s0 and -s0 the cone V_r holds both, one or none, and a "
      "detaching axis is in it. The "
      "smallest relation with a one-way axis has two contacts that face each other off one line: they make a "
      "couple.";
  return outcome;
}

Outcome TryProposition5(Effort effort) {
  return TryProjection("thesis.2.2.1.proposition-5", effort,
                       "G is taken from the facets of the projected cone, as step 1 says (its V_a must be "
                       "read V_r: S1 does not occur in "
                       "(2.6)), and 3 - rank G - m_r is held against the engine's formula, which needs no "
                       "projection: the two-way axes are the "
                       "projection of the smallest face of V_a that holds every legal translation, so m_r + "
                       "d_r1 = 3 - (rank A(I_t) - rank N(I_t)).\n\n"
                       "For all relations: w and -w are both in V_r just if w belongs to that face's "
                       "projection. If V in the face has angular part w, "
                       "subtracting it from a large multiple of a legal translation in the face's interior "
                       "stays legal; if (w, v) and (-w, v') are legal, "
                       "their sum is a legal translation, so both lie in the smallest face that holds it.",
                       [](const Definitions& d, const MotionDof& dof) {
                         return 3 - d.rank_g - d.maintaining_rotation == dof.rotation.detaching_type1 &&
                                d.two_way_rotation - d.maintaining_rotation == dof.rotation.detaching_type1;
                       });
}

Outcome TryProposition6(Effort effort) {
  const std::vector<Assertion> laws = {
      {{{"rotation.detaching", 1}, {"rotation.detaching_type1", -1}, {"rotation.detaching_type2", -1}},
       "zero"},
      {{{"rotation.detaching_type1", 1}}, "nonnegative"},
      {{{"rotation.detaching_type2", 1}}, "nonnegative"}};
  return LawsHoldThroughout(
      enumerators::AxisWorld(CensusSize(effort)), "thesis.2.2.1.proposition-6", laws,
      "Neither type ever comes out negative: the maintaining axes are two-way axes, and the "
      "two-way axes are in V_r.");
}

}  // namespace

std::vector<Claim> PropositionClaims() {
  return {
      {"thesis.2.2.1.proposition-1",
       "The constraining DOF in rotation is c_r = 3 - d(V_r), V_r the axis directions of V_a.",
       "2.2.1, Proposition 1", "exhaustive", TryProposition1},
      {"thesis.2.2.1.proposition-2", "The detaching DOF in rotation is d_r = 3 - (m_r + c_r).",
       "2.2.1, Proposition 2", "exhaustive", TryProposition2},
      {"thesis.2.2.1.axis-types",
       "Every axis direction belongs to exactly one of maintaining, detaching and constraining displacement.",
       "2.2.1, proof of Proposition 2", "exhaustive", TryAxisTypes},
      {"thesis.2.2.1.proposition-3", "The maintaining DOF in rotation is m_r = m_a - m_t.",
       "2.2.1, Proposition 3", "exhaustive", TryProposition3},
      {"thesis.2.2.1.proposition-4",
       "A detaching axis direction is one about which the object can turn both ways, or one way only.",
       "2.2.1, Proposition 4", "exhaustive", TryProposition4},
      {"thesis.2.2.1.proposition-5", "The Type I detaching DOF in rotation is d_r1 = 3 - Rank(G) - m_r.",
       "2.2.1, Proposition 5", "exhaustive", TryProposition5},
      {"thesis.2.2.1.proposition-6", "The Type II detaching DOF in rotation is d_r2 = d_r - d_r1.",
       "2.2.1, Proposition 6", "exhaustive", TryProposition6}};
}

}  // namespace tact::provers
