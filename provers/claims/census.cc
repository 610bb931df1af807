#include "provers/claims/census.h"

#include <map>

#include "algebra/contact/motion_dof.h"

namespace tact::provers {

using algebra::ContactRelation;
using algebra::MotionDof;
using enumerators::ContactWorld;

size_t CensusSize(Effort effort) {
  return effort == Effort::kQuick ? 3 : (effort == Effort::kStandard ? 4 : 5);
}
size_t ProjectionSize(Effort effort) {
  return effort == Effort::kQuick ? 2 : (effort == Effort::kStandard ? 3 : 4);
}

Census TakeCensus(const ContactWorld& world) {
  std::map<MotionDof, CensusClass> classes;
  Census census{world, 0, {}};
  algebra::MotionDofEngine engine;
  ForEachRelation(world, [&](const ContactRelation& relation) {
    const MotionDof dof = engine.Compute(relation);
    CensusClass& found = classes[dof];
    if (found.count == 0) {
      found.dof = dof;
      found.witness = relation;
    }
    ++found.count;
    ++census.count;
  });
  for (auto& [dof, found] : classes) census.classes.push_back(std::move(found));
  return census;
}

const CensusClass* SmallestClass(const Census& census,
                                 const std::function<bool(const MotionDof&)>& property) {
  const CensusClass* smallest = nullptr;
  for (const CensusClass& c : census.classes) {
    if (!property(c.dof)) continue;
    if (smallest == nullptr || c.witness.contacts.size() < smallest->witness.contacts.size()) smallest = &c;
  }
  return smallest;
}

Outcome LawsHoldThroughout(const ContactWorld& world, const std::string& claim_id,
                           const std::vector<Assertion>& laws, const std::string& prose) {
  const Census census = TakeCensus(world);
  Outcome outcome;
  outcome.bound = world.sentence;
  outcome.numbers = {{"relations", static_cast<long long>(census.count)},
                     {"classes", static_cast<long long>(census.classes.size())}};
  outcome.verdict = Verdict::kHoldsTo;
  outcome.evidence = prose;
  for (size_t i = 0; i < laws.size(); ++i) {
    const CensusClass* failure =
        SmallestClass(census, [&](const MotionDof& dof) { return !Holds(laws[i], dof); });
    if (failure == nullptr) continue;
    outcome.verdict = Verdict::kRefuted;
    outcome.evidence += "\n\nSmallest counterexample to law " + std::to_string(i + 1) + ": " +
                        Describe(failure->witness) + ".";
    outcome.certificates.push_back(MotionDofCertificate(claim_id + ".counterexample-" + std::to_string(i + 1),
                                                        claim_id, failure->witness, {}));
  }
  if (outcome.verdict == Verdict::kHoldsTo) {
    outcome.certificates = {CensusCertificate(claim_id + ".census", claim_id, world, census.classes, laws)};
  }
  return outcome;
}

std::optional<ContactRelation> FirstFailure(
    const ContactWorld& world,
    const std::function<bool(const ContactRelation&, const MotionDof&)>& statement) {
  std::optional<ContactRelation> failure;
  algebra::MotionDofEngine engine;
  ForEachRelation(world, [&](const ContactRelation& relation) {
    if (!failure && !statement(relation, engine.Compute(relation))) failure = relation;
  });
  return failure;
}

std::string Describe(const ContactRelation& relation) {
  if (relation.contacts.empty()) return "no contact at all";
  std::string text = std::to_string(relation.contacts.size());
  text += relation.contacts.size() == 1 ? " contact:" : " contacts:";
  for (size_t i = 0; i < relation.contacts.size(); ++i) {
    const algebra::Contact& c = relation.contacts[i];
    text += (i == 0 ? " at " : "; at ") + ToString(c.point) + " with normal ";
    for (size_t j = 0; j < c.planes.size(); ++j) text += (j == 0 ? "" : " or ") + ToString(c.planes[j]);
  }
  return text;
}

Outcome HoldsThroughout(const ContactWorld& world, const std::string& claim_id,
                        const std::function<bool(const ContactRelation&, const MotionDof&)>& statement) {
  Outcome outcome;
  outcome.bound = world.sentence;
  outcome.numbers = {{"relations", static_cast<long long>(Count(world))}};
  if (const auto failure = FirstFailure(world, statement)) {
    outcome.verdict = Verdict::kRefuted;
    outcome.evidence = "Smallest counterexample: " + Describe(*failure) + ".";
    outcome.certificates.push_back(
        MotionDofCertificate(claim_id + ".counterexample", claim_id, *failure, {}));
  } else {
    outcome.verdict = Verdict::kHoldsTo;
  }
  return outcome;
}

std::vector<std::string> DofCells(const MotionDof& dof) {
  const auto text = [](int value) { return std::to_string(value); };
  const auto& [t, r, a] = std::tie(dof.translation, dof.rotation, dof.all);
  return {dof.singular ? "singular" : "",
          text(t.maintaining) + " " + text(t.detaching) + " " + text(t.constraining),
          text(r.maintaining) + " " + text(r.detaching) + " " + text(r.constraining),
          text(r.detaching_type1) + " / " + text(r.detaching_type2),
          text(a.maintaining) + " " + text(a.detaching) + " " + text(a.constraining),
          text(t.restricted) + " " + text(r.restricted) + " " + text(a.restricted)};
}

std::vector<std::string> DofHeader() {
  // The letters of a heading stay together where it is broken.
  return {"",
          "translation m\u00a0d\u00a0c",
          "rotation m\u00a0d\u00a0c",
          "Type I\u00a0/\u00a0II",
          "all motion m\u00a0d\u00a0c",
          "restricted t\u00a0r\u00a0a"};
}

}  // namespace tact::provers
