#include <algorithm>
#include <map>
#include <set>

#include "algebra/exact/linear_algebra.h"
#include "provers/claims/basis_reduction.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/definitions.h"
#include "provers/claims/dof_laws.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::Integer;
using algebra::IntegerMatrix;
using algebra::MotionDof;

Outcome TrySums(Effort effort) {
  return LawsHoldThroughout(
      enumerators::AxisWorld(CensusSize(effort)), "thesis.2.3.1.sums", SumLaws(),
      "The detaching DOF is defined as what is left, so the sums hold by definition; what could fail is that "
      "it comes "
      "out negative. It never does, and for a reason that needs no bound: the maintaining motions are "
      "contained in "
      "the legal ones, in all motion, in translation and in projection, so m <= dim V = total - c.");
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
  const auto fails = [&](const Assertion& law) {
    return [&law](const MotionDof& dof) { return !Holds(law, dof); };
  };
  const CensusClass* smallest = SmallestClass(census, fails(constraining));
  size_t without_detaching = 0, without_constraining = 0;
  for (const CensusClass& c : census.classes) {
    without_detaching += Holds(detaching, c.dof) ? 0 : c.count;
    without_constraining += Holds(constraining, c.dof) ? 0 : c.count;
  }
  Outcome outcome;
  outcome.bound = "smallest counterexample: two contacts; for none or one both equations hold";
  if (smallest == nullptr) return outcome;
  outcome.verdict = Verdict::kProved;
  outcome.numbers = {{"relations tried", static_cast<long long>(census.count)},
                     {"with c_r other than c_a - c_t", static_cast<long long>(without_constraining)},
                     {"with d_r other than d_a - d_t", static_cast<long long>(without_detaching)},
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
  return LawsHoldThroughout(
      enumerators::AxisWorld(CensusSize(effort)), "thesis.2.6.footnote", RestrictedLaws("zero"),
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
      {"thesis.2.2.1.figure-2.2",
       "The algorithm of Fig. 2.2 ends with m_t translations and screws whose axis directions are linearly "
       "independent.",
       "2.2.1, Fig. 2.2", "exhaustive", TryBasisAlgorithm},
      {"thesis.2.2.1.not-differences", "d_r = d_a - d_t and c_r = c_a - c_t are not always satisfied.",
       "2.2.1, after Proposition 3", "exhaustive", TryWarning},
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
