#include <algorithm>
#include <map>
#include <set>

#include "algebra/contact/contact_rows.h"
#include "algebra/exact/linear_algebra.h"
#include "provers/claims/basis_reduction.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/definitions.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::Integer;
using algebra::IntegerMatrix;
using algebra::MotionDof;

const char* const kRotation = "rotation.";

// How many contacts: the first world for fast formulas, the second where true projections are computed.
size_t CensusSize(Effort effort) {
  return effort == Effort::kQuick ? 3 : (effort == Effort::kStandard ? 4 : 5);
}
size_t ProjectionSize(Effort effort) {
  return effort == Effort::kQuick ? 2 : (effort == Effort::kStandard ? 3 : 4);
}

// A law of the DOF indices over the axis world, each class with its witness in the certificate.
Outcome TryLaws(const std::string& id, const std::vector<Assertion>& laws, Effort effort,
                const std::string& prose) {
  const Census census = TakeCensus(enumerators::AxisWorld(CensusSize(effort)));
  Outcome outcome;
  outcome.bound = census.world.sentence;
  outcome.numbers = {{"relations", static_cast<long long>(census.count)},
                     {"classes", static_cast<long long>(census.classes.size())}};
  outcome.verdict = Verdict::kHoldsTo;
  outcome.evidence = prose;
  for (const Assertion& law : laws) {
    const auto violations = Violations(census, law);
    if (violations.empty()) continue;
    outcome.verdict = Verdict::kRefuted;
    outcome.evidence += "\n\nSmallest counterexample: " + Describe(violations.front().witness) + ".";
  }
  outcome.certificates.push_back(
      CensusCertificate(id + ".census", id, census.world, census.classes,
                        outcome.verdict == Verdict::kHoldsTo ? laws : std::vector<Assertion>{}));
  return outcome;
}

Outcome TrySums(Effort effort) {
  const std::vector<Assertion> laws = {
      {{{"translation.maintaining", 1},
        {"translation.detaching", 1},
        {"translation.constraining", 1},
        {"constant", -3}},
       "zero"},
      {{{"rotation.maintaining", 1},
        {"rotation.detaching", 1},
        {"rotation.constraining", 1},
        {"constant", -3}},
       "zero"},
      {{{"all.maintaining", 1}, {"all.detaching", 1}, {"all.constraining", 1}, {"constant", -6}}, "zero"},
      {{{"translation.detaching", 1}}, "nonnegative"},
      {{{"rotation.detaching", 1}}, "nonnegative"},
      {{{"all.detaching", 1}}, "nonnegative"}};
  return TryLaws(
      "thesis.2.3.1.sums", laws, effort,
      "The detaching DOF is defined as what is left, so the sums hold by definition; what could fail is that "
      "it comes "
      "out negative. It never does, and for a reason that needs no bound: the maintaining motions are "
      "contained in "
      "the legal ones, in all motion, in translation and in projection, so m <= dim V = total - c.");
}

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
    const std::string index = kRotation + std::string("detaching_type") + std::to_string(type);
    const Assertion occurs{{{index, 1}}, "positive"};
    const CensusClass* smallest = nullptr;
    for (const CensusClass& c : census.classes) {
      if (Holds(occurs, c.dof) &&
          (smallest == nullptr || c.witness.contacts.size() < smallest->witness.contacts.size())) {
        smallest = &c;
      }
    }
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
  return TryLaws("thesis.2.2.1.proposition-6", laws, effort,
                 "Neither type ever comes out negative: the maintaining axes are two-way axes, and the "
                 "two-way axes are in V_r.");
}

Outcome TryBasisAlgorithm(Effort effort) {
  const std::string id = "thesis.2.2.1.figure-2.2";
  const auto world = enumerators::AxisWorld(ProjectionSize(effort));
  Outcome outcome;
  outcome.bound =
      world.sentence + "; the canonical basis of each maintaining space and one with neighbours added up";
  std::set<std::vector<Integer>> seen;
  std::map<std::pair<size_t, int>, Certificate> certificates;
  long long spaces = 0, runs = 0, failures = 0, rounds = 0;
  ForEachRelation(world, [&](const ContactRelation& relation) {
    const IntegerMatrix rows = LegalRows(relation);
    const IntegerMatrix basis = NullSpace(rows);
    if (!seen.insert(basis.entries).second) return;
    ++spaces;
    std::vector<Screw> plain;
    for (size_t i = 0; i < basis.rows; ++i) plain.push_back(basis.RowVector(i));
    std::vector<Screw> mixed = plain;
    for (size_t i = 0; i + 1 < mixed.size(); ++i) {
      for (int j = 0; j < 6; ++j) mixed[i][j] += mixed[i + 1][j];
    }
    const int translations = algebra::ComputeMotionDof(relation).translation.maintaining;
    for (const auto* screws : {&plain, &mixed}) {
      for (const bool last : {false, true}) {
        const ReducedBasis reduced = ReduceBasis(*screws, last);
        ++runs;
        rounds = std::max<long long>(rounds, reduced.rounds);
        failures += reduced.translations == translations ? 0 : 1;
        if (screws == &mixed && last) {
          const std::string name =
              id + "." + std::to_string(screws->size()) + "-" + std::to_string(translations);
          certificates.try_emplace({screws->size(), translations},
                                   BasisCertificate(name, id, *screws, reduced.screws, reduced.translations));
        }
      }
    }
  });
  outcome.verdict = failures == 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  outcome.numbers = {
      {"maintaining spaces", spaces}, {"runs", runs}, {"failures", failures}, {"most rounds", rounds}};
  for (auto& [key, certificate] : certificates) outcome.certificates.push_back(std::move(certificate));
  outcome.evidence =
      "Run literally, with both extremes of what step 3 leaves open. It ends because each round leaves one "
      "non-zero angular part "
      "fewer; removing any member of C is right because every coefficient is non-zero, so the removed screw "
      "is a combination of "
      "the others and the new one. Certificates: for each pair of dimensions that occurs, a basis and what "
      "became of it.";
  return outcome;
}

Outcome TryWarning(Effort effort) {
  const std::string id = "thesis.2.2.1.not-differences";
  const Assertion detaching{{{"rotation.detaching", 1}, {"all.detaching", -1}, {"translation.detaching", 1}},
                            "zero"};
  const Assertion constraining{
      {{"rotation.constraining", 1}, {"all.constraining", -1}, {"translation.constraining", 1}}, "zero"};
  const Census census = TakeCensus(enumerators::AxisWorld(CensusSize(effort)));
  const auto not_detaching = Violations(census, detaching),
             not_constraining = Violations(census, constraining);
  Outcome outcome;
  outcome.bound = "smallest counterexample: two contacts; for none or one both equations hold";
  size_t relations = 0, most = 0;
  const CensusClass* smallest = nullptr;
  for (const CensusClass& c : not_constraining) {
    relations += c.count;
    if (smallest == nullptr || c.witness.contacts.size() < smallest->witness.contacts.size()) smallest = &c;
  }
  for (const CensusClass& c : not_detaching) most += c.count;
  if (smallest == nullptr) return outcome;
  outcome.verdict = Verdict::kProved;
  outcome.numbers = {{"relations tried", static_cast<long long>(census.count)},
                     {"with c_r other than c_a - c_t", static_cast<long long>(relations)},
                     {"with d_r other than d_a - d_t", static_cast<long long>(most)},
                     {"fewest contacts", static_cast<long long>(smallest->witness.contacts.size())}};
  const Assertion fails_d{detaching.sum, "nonzero"}, fails_c{constraining.sum, "nonzero"};
  outcome.certificates = {
      MotionDofCertificate(id + ".counterexample", id, smallest->witness, {fails_d, fails_c})};
  outcome.tables = {{"The smallest counterexample", DofHeader(), {DofCells(smallest->dof)}}};
  outcome.evidence =
      "Smallest counterexample: " + Describe(smallest->witness) +
      ". No translation leaves the pair's normal plane, so c_t = 1; but a couple turns the two normals "
      "apart, no motion is "
      "excluded in both directions by all motions together, and c_a = c_r = 0: c_r is not c_a - c_t = -1.\n\n"
      "The two equations fail together or not at all: m_r = m_a - m_t always, and the sums are 3, 3 and 6, "
      "so the errors of d_r and c_r are "
      "opposite. They hold exactly when the implicit equalities of translation have no more rank in force "
      "than those of all motion.";
  return outcome;
}

Outcome TryFootnote(Effort effort) {
  std::vector<Assertion> laws;
  for (const std::string motion : {"translation", "rotation", "all"}) {
    laws.push_back(
        {{{motion + ".restricted", 1}, {motion + ".detaching", -1}, {motion + ".constraining", -1}}, "zero"});
  }
  return TryLaws("thesis.2.6.footnote", laws, effort,
                 "With one plane a contact the restricted DOFs are the ranks themselves: rank N = 3 - m_t, "
                 "rank A = 6 - m_a, and their "
                 "difference 3 - m_r by Proposition 3.");
}

// Every linearly dependent minimum combination of normals gives one equation for S0 [thesis, A.1].
int RankOfRotationEquations(const IntegerMatrix& rows) {
  std::vector<algebra::IntegerVector> equations;
  const size_t count = rows.rows;
  for (size_t mask = 1; mask < size_t{1} << count; ++mask) {
    if (__builtin_popcountll(mask) > 4) continue;
    std::vector<size_t> members;
    for (size_t i = 0; i < count; ++i) {
      if ((mask >> i & 1) != 0) members.push_back(i);
    }
    std::vector<algebra::IntegerVector> forces(3);
    for (int axis = 0; axis < 3; ++axis) {
      for (const size_t i : members) forces[axis].push_back(rows.row(i)[3 + axis]);
    }
    const IntegerMatrix relations = NullSpace(IntegerMatrix::FromRows(forces, members.size()));
    if (relations.rows != 1) continue;
    algebra::IntegerVector g(3, Integer(0));
    bool minimum = true;
    for (size_t k = 0; k < members.size(); ++k) {
      minimum = minimum && relations.row(0)[k].sign() != 0;
      for (int j = 0; j < 3; ++j) g[j] += relations.row(0)[k] * rows.row(members[k])[j];
    }
    if (minimum) equations.push_back(g);
  }
  return static_cast<int>(Rank(IntegerMatrix::FromRows(equations, 3)));
}

Outcome TryRotationEquations(Effort effort) {
  Outcome outcome =
      HoldsThroughout(enumerators::AxisWorld(CensusSize(effort) - 1), "thesis.A.1.rotation-equations",
                      [](const ContactRelation& relation, const MotionDof& dof) {
                        return RankOfRotationEquations(LegalRows(relation)) == dof.rotation.restricted;
                      });
  outcome.evidence =
      "All minimum combinations are searched, S1 is eliminated from each, and the rank of the equations in "
      "S0 is held against r_a - r_t.\n\n"
      "For all relations: the combinations span the left null space of N, whose dimension is n - rank N; "
      "applied to A they give rank A - rank N "
      "independent equations, since a combination that also cancels the angular parts is a left null vector "
      "of A." +
      (outcome.evidence.empty() ? "" : "\n\n" + outcome.evidence);
  return outcome;
}

}  // namespace

std::vector<Claim> MotionDofClaims() {
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
      {"thesis.2.2.1.figure-2.2",
       "The algorithm of Fig. 2.2 ends with m_t translations and screws whose axis directions are linearly "
       "independent.",
       "2.2.1, Fig. 2.2", "exhaustive", TryBasisAlgorithm},
      {"thesis.2.2.1.not-differences", "d_r = d_a - d_t and c_r = c_a - c_t are not always satisfied.",
       "2.2.1, after Proposition 3", "exhaustive", TryWarning},
      {"thesis.2.2.1.proposition-4",
       "A detaching axis direction is one about which the object can turn both ways, or one way only.",
       "2.2.1, Proposition 4", "exhaustive", TryProposition4},
      {"thesis.2.2.1.proposition-5", "The Type I detaching DOF in rotation is d_r1 = 3 - Rank(G) - m_r.",
       "2.2.1, Proposition 5", "exhaustive", TryProposition5},
      {"thesis.2.2.1.proposition-6", "The Type II detaching DOF in rotation is d_r2 = d_r - d_r1.",
       "2.2.1, Proposition 6", "exhaustive", TryProposition6},
      {"thesis.2.3.1.sums", "The motion DOFs in translation and in rotation each add up to three.", "2.3.1",
       "exhaustive", TrySums},
      {"thesis.2.6.footnote",
       "In a non-singular relation each restricted DOF is the sum of the detaching and the constraining DOF.",
       "2.6, footnote 1", "exhaustive", TryFootnote},
      {"thesis.A.1.rotation-equations",
       "The rank of the equations in S0 alone (A.7) is the restricted DOF in rotation.",
       "A.1, Equation (A.7)", "exhaustive", TryRotationEquations}};
}

}  // namespace tact::provers
