#include <algorithm>
#include <map>
#include <set>

#include "enumerators/dof_census.h"
#include "enumerators/dof_class.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"
#include "provers/claims/dof_laws.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::MotionDof;
using enumerators::DofCensus;
using enumerators::DofDefinition;

// The witnesses of a world, by increasing DOFs.
struct Witnesses {
  std::vector<ContactRelation> relations;
  std::vector<MotionDof> dofs;
  std::vector<uint64_t> counts;
  uint64_t searched = 0;
  std::string world;
};

Witnesses Search(enumerators::ContactWorld world) {
  const DofCensus census(std::move(world));
  Witnesses found;
  found.searched = census.relations();
  found.world = census.world().sentence;
  for (const enumerators::DofCount& c : census.Count()) {
    found.relations.push_back(census.Relation(c.witness));
    found.dofs.push_back(c.dof);
    found.counts.push_back(c.count);
  }
  return found;
}

const Witnesses& AnySolids() {
  static const Witnesses witnesses = Search(enumerators::CornerWorld(7));
  return witnesses;
}

const Witnesses& Boxes() {
  static const Witnesses witnesses = Search(enumerators::CubeWorld(9));
  return witnesses;
}

// Level contacts whose lines of action meet one upright line: forces that meet, and couples across.
Witnesses LevelSolids() {
  enumerators::ContactWorld world = enumerators::DiagonalWorld(4);
  std::erase_if(world.contacts, [](const algebra::Contact& contact) {
    const algebra::Vector3& normal = contact.planes[0];
    return normal.z.sign() != 0 || Cross(contact.point, normal).z.sign() != 0;
  });
  return Search(std::move(world));
}

const DofDefinition& Definition(const std::string& name) {
  const auto& all = enumerators::DofDefinitions();
  return *std::find_if(all.begin(), all.end(), [&](const DofDefinition& d) { return d.name == name; });
}

std::string Join(const std::vector<int>& values) {
  std::string text;
  for (const int v : values) text += (text.empty() ? "" : " ") + std::to_string(v);
  return text;
}

Table CountsTable() {
  Table table{"DOF classes by the indices that tell relations apart",
              {"indices", "solids of any faces", "axis-parallel faces", "with a contact"},
              {}};
  for (const DofDefinition& d : enumerators::DofDefinitions()) {
    const size_t boxes = CountDistinct(Boxes().dofs, d);
    std::vector<MotionDof> touching;
    for (size_t i = 0; i < Boxes().dofs.size(); ++i) {
      if (!Boxes().relations[i].contacts.empty()) touching.push_back(Boxes().dofs[i]);
    }
    table.rows.push_back({d.name, std::to_string(CountDistinct(AnySolids().dofs, d)), std::to_string(boxes),
                          std::to_string(CountDistinct(touching, d))});
  }
  return table;
}

Table LemmaTable() {
  Table table{"What excludes the candidates that do not occur", {"lemma", "statement", "excludes first"}, {}};
  std::vector<size_t> first(enumerators::DofLemmas().size(), 0);
  for (const MotionDof& candidate : enumerators::DofCandidates()) {
    if (const auto lemma = enumerators::ExcludingLemma(candidate)) ++first[*lemma];
  }
  for (size_t i = 0; i < first.size(); ++i) {
    const auto& lemma = enumerators::DofLemmas()[i];
    table.rows.push_back({lemma.id, lemma.statement, std::to_string(first[i])});
  }
  return table;
}

// Every class of the definition, with the smallest of its witnesses.
Table ClassTable(const DofDefinition& definition, const Witnesses& witnesses) {
  Table table{"The classes: " + definition.name, {"indices", "fewest contacts", "witness"}, {}};
  std::map<std::vector<int>, size_t> smallest;
  for (size_t i = 0; i < witnesses.dofs.size(); ++i) {
    const auto [at, is_new] = smallest.emplace(IndexValues(witnesses.dofs[i], definition), i);
    if (!is_new && witnesses.relations[i].contacts.size() < witnesses.relations[at->second].contacts.size())
      at->second = i;
  }
  for (const auto& [values, i] : smallest) {
    table.rows.push_back({Join(values), std::to_string(witnesses.relations[i].contacts.size()),
                          Describe(witnesses.relations[i])});
  }
  return table;
}

Certificate ListCertificate(const std::string& id, ClassList list,
                            const std::vector<ContactRelation>& witnesses) {
  return DofClassesCertificate(id, id, list, witnesses, enumerators::DofDefinitions());
}

std::string Searched(const Witnesses& witnesses) {
  return "witnesses from " + std::to_string(witnesses.searched) + " relations (" + witnesses.world + ")";
}

constexpr const char* kMeeting =
    "Upper bound: each of the 1050 tuples whose sums are right is either among the 142 or excluded by one of "
    "seven "
    "lemmas (docs/dof-classes.md has the proofs). Lower bound: a witness for each of the 142, with the "
    "fewest "
    "contacts that its class can have. The two meet, so the list is complete; the checker goes through it "
    "again.";

Outcome TryTenKinds(Effort) {
  const std::string id = "thesis.2.3.ten-kinds";
  const DofDefinition& translation = Definition("translation");
  const size_t classes = CountDistinct(AnySolids().dofs, translation);
  Outcome outcome;
  outcome.verdict =
      classes == 10 && AnySolids().dofs == enumerators::DofClasses() ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "complete";
  outcome.numbers = {{"classes in translation", static_cast<long long>(classes)}};
  outcome.tables = {ClassTable(translation, AnySolids())};
  outcome.certificates = {ListCertificate(id, ClassList::kAnyFaces, AnySolids().relations)};
  outcome.evidence =
      "The ten are the ways to write three as an ordered sum of three: no more are possible, and each has a "
      "witness. "
      "Every witness is one of face contacts too, since a wall can be put behind each contacting point.";
  return outcome;
}

Outcome Try138(Effort) {
  const std::string id = "thesis.2.3.kinds-138";
  const auto count = [](const std::string& name) {
    return static_cast<long long>(CountDistinct(AnySolids().dofs, Definition(name)));
  };
  const bool complete = AnySolids().dofs == enumerators::DofClasses();
  const bool reproduced =
      std::any_of(enumerators::DofDefinitions().begin(), enumerators::DofDefinitions().end(),
                  [](const DofDefinition& d) { return CountDistinct(AnySolids().dofs, d) == 138; });
  Outcome outcome;
  outcome.bound = "complete; " + Searched(AnySolids());
  if (!complete) {
    outcome.evidence = "The world holds no witness of some class that the lemmas leave.";
    return outcome;
  }
  outcome.verdict = reproduced ? Verdict::kProved : Verdict::kRefuted;
  outcome.numbers = {{"translation and rotation", count("translation, rotation")},
                     {"with Types I and II", count("translation, rotation with types")},
                     {"with all motion", count("translation, rotation, all motion")},
                     {"with both", count("translation, rotation with types, all motion")},
                     {"printed", 138}};
  outcome.tables = {CountsTable(), LemmaTable(),
                    ClassTable(Definition("translation, rotation with types, all motion"), AnySolids())};
  outcome.certificates = {ListCertificate(id, ClassList::kAnyFaces, AnySolids().relations)};
  outcome.evidence =
      "Read literally - indices in translation and rotation - there are 66 kinds, and 90, 107 or 142 with "
      "Types I and II, "
      "all motion, or both. None of the eleven readings gives 138.\n\n" +
      std::string(kMeeting) +
      "\n\nWhat does give it: see thesis.2.3.kinds-138-boxes. Three of the 142 cannot be had with "
      "axis-parallel faces, and "
      "one of the 139 others is the relation in which nothing touches.";
  return outcome;
}

Outcome TryBoxes(Effort) {
  const std::string id = "thesis.2.3.kinds-138-boxes";
  Outcome outcome;
  outcome.bound = "complete; " + Searched(Boxes());
  const auto touching = std::count_if(Boxes().relations.begin(), Boxes().relations.end(),
                                      [](const ContactRelation& r) { return !r.contacts.empty(); });
  const bool complete = Boxes().dofs == enumerators::BoxClasses();
  if (complete) outcome.verdict = touching == 138 ? Verdict::kProved : Verdict::kRefuted;
  outcome.numbers = {{"classes", static_cast<long long>(Boxes().dofs.size())}, {"with a contact", touching}};
  Table missing{
      "What solids of other faces have besides",
      {"m d c in translation; m d1 d2 c in rotation; m d c in all motion", "fewest contacts", "witness"},
      {}};
  for (size_t i = 0; i < AnySolids().dofs.size(); ++i) {
    if (std::binary_search(Boxes().dofs.begin(), Boxes().dofs.end(), AnySolids().dofs[i])) continue;
    missing.rows.push_back(
        {Join(IndexValues(AnySolids().dofs[i], Definition("translation, rotation with types, all motion"))),
         std::to_string(AnySolids().relations[i].contacts.size()), Describe(AnySolids().relations[i])});
  }
  outcome.tables = {std::move(missing), CountsTable()};
  outcome.certificates = {ListCertificate(id, ClassList::kAxisParallelFaces, Boxes().relations)};
  outcome.evidence =
      "Solids whose faces are all parallel to the coordinate planes - what one draws, and what a search with "
      "blocks "
      "finds - have 139 classes when all indices tell them apart, Types I and II and all motion included. "
      "One of them "
      "is the relation without contacts; 138 are contact relations. Two more lemmas exclude the three "
      "classes that are "
      "missing (docs/dof-classes.md). Whether this is how the printed number came about cannot be known; "
      "that it gives "
      "the number is proved.";
  return outcome;
}

Outcome TryFootnote(Effort) {
  const std::string id = "thesis.2.3.2.footnote";
  Outcome outcome;
  const auto equal = RestrictedLaws("zero");
  const auto failures =
      std::count_if(AnySolids().dofs.begin(), AnySolids().dofs.end(), [&](const MotionDof& dof) {
        return !std::all_of(equal.begin(), equal.end(),
                            [&](const Assertion& law) { return Holds(law, dof); });
      });
  outcome.verdict = failures == 0 ? Verdict::kProved : Verdict::kRefuted;
  outcome.bound = "complete: all 142 classes";
  outcome.numbers = {{"classes", static_cast<long long>(AnySolids().dofs.size())}, {"failures", failures}};
  outcome.certificates = {ListCertificate(id, ClassList::kAnyFaces, AnySolids().relations)};
  outcome.evidence =
      "Held against every class there is: the restricted DOFs are ranks, the maintaining ones what the ranks "
      "leave, so the sums agree. "
      "The other half of the footnote, on singular relations, is thesis.2.6.footnote-singular: read as "
      "'never equal' it is refuted, and "
      "what holds is an inequality (thesis.2.6.footnote-inequality).";
  return outcome;
}

// Singular contacts with two planes near the corner world's contacts.
std::vector<algebra::Contact> SingularContacts() {
  const std::vector<algebra::Vector3> normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {-1, 0, 1}};
  std::vector<algebra::Contact> contacts;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) {
        for (size_t i = 0; i < normals.size(); ++i) {
          for (size_t j = i + 1; j < normals.size(); ++j)
            contacts.push_back({{x, y, z}, {normals[i], normals[j]}, ""});
        }
      }
    }
  }
  return contacts;
}

// Adds singular contacts to a relation, one after the other, keeping the first relation for each new DOFs.
void Extend(const ContactRelation& relation, size_t more, std::map<MotionDof, ContactRelation>& found) {
  if (more == 0) return;
  std::vector<ContactRelation> fresh;
  for (const algebra::Contact& contact : SingularContacts()) {
    ContactRelation extended = relation;
    extended.contacts.push_back(contact);
    if (found.emplace(ComputeMotionDof(extended), extended).second) fresh.push_back(std::move(extended));
  }
  for (const ContactRelation& next : fresh) Extend(next, more - 1, found);
}

Outcome TrySingularKinds(Effort) {
  const std::string id = "thesis.2.3.singular-kinds";
  std::map<MotionDof, ContactRelation> found;
  for (const ContactRelation& relation : AnySolids().relations) Extend(relation, 3, found);
  // Some tuples need other members of their class: a singular contact that adds one couple only.
  for (const ContactRelation& relation : LevelSolids().relations) Extend(relation, 1, found);
  const std::vector<MotionDof> candidates = enumerators::SingularClasses();
  const std::set<MotionDof> allowed(candidates.begin(), candidates.end());
  Outcome outcome;
  long long outside = 0, missing = 0;
  for (const auto& [dof, relation] : found) outside += allowed.contains(dof) ? 0 : 1;
  Table table{"Tuples without a witness yet", DofHeader(), {}};
  for (const MotionDof& dof : allowed) {
    if (found.contains(dof)) continue;
    ++missing;
    table.rows.push_back(DofCells(dof));
  }
  outcome.numbers = {
      {"singular DOFs without the restricted ones", static_cast<long long>(AnySolids().dofs.size())},
      {"with them, at most", static_cast<long long>(allowed.size())},
      {"witnessed", static_cast<long long>(found.size()) - outside},
      {"outside what is allowed", outside}};
  outcome.verdict = outside > 0 ? Verdict::kRefuted : (missing == 0 ? Verdict::kProved : Verdict::kHoldsTo);
  outcome.bound = missing == 0 ? "complete" : "witnesses with up to three singular contacts";
  std::vector<ContactRelation> witnesses;
  for (const auto& [dof, relation] : found) witnesses.push_back(relation);
  if (missing == 0 && outside == 0)
    outcome.certificates = {ListCertificate(id, ClassList::kSingular, witnesses)};
  if (missing > 0) outcome.tables = {std::move(table)};
  outcome.evidence =
      "The singular DOFs are those of the contacts that are left when the singular ones are taken away, so "
      "all 142 tuples occur, each "
      "with a singular contact added that changes none of them. Together with the restricted DOFs, which "
      "count every plane, there are "
      "more: R_t >= max(2, r_t), R_r >= r_r, both at most 3.";
  return outcome;
}

}  // namespace

std::vector<Claim> DofClassClaims() {
  return {
      {"thesis.2.3.ten-kinds",
       "By their maintaining, detaching and constraining DOFs in translation there are ten kinds of "
       "contact relations.",
       "2.3", "exhaustive", TryTenKinds},
      {"thesis.2.3.kinds-138",
       "By their maintaining, detaching and constraining DOFs in translation and rotation there are 138 "
       "kinds of "
       "non-singular contact relations.",
       "2.3", "exhaustive", Try138},
      {"thesis.2.3.kinds-138-boxes",
       "Of solids with axis-parallel faces there are 138 kinds of non-singular relations with a contact, "
       "all indices "
       "taken together.",
       "2.3, corrected", "exhaustive", TryBoxes},
      {"thesis.2.3.singular-kinds",
       "Every tuple of motion DOFs of a non-singular relation is one of singular DOFs of a singular "
       "relation, with every restricted "
       "DOF that the planes' number allows.",
       "2.3 and 2.2.2", "exhaustive", TrySingularKinds},
      {"thesis.2.3.2.footnote",
       "In a non-singular relation each restricted DOF is the sum of the detaching and the constraining DOF.",
       "2.3.2 and 2.6, footnote 1, on the complete list of classes", "exhaustive", TryFootnote}};
}

}  // namespace tact::provers
