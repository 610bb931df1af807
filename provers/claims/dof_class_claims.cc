#include <algorithm>
#include <map>

#include "enumerators/dof_census.h"
#include "enumerators/dof_class.h"
#include "provers/claims/census.h"
#include "provers/claims/claims.h"

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

Certificate ListCertificate(const std::string& id, const Witnesses& witnesses, Faces faces) {
  return DofClassesCertificate(id, id, faces, witnesses.relations, enumerators::DofDefinitions(),
                               faces == Faces::kAny);
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
  outcome.certificates = {ListCertificate(id, AnySolids(), Faces::kAny)};
  outcome.evidence =
      "The ten are the ways to write three as an ordered sum of three: no more are possible, and each has a "
      "witness. "
      "Every witness is one of face contacts too, since a wall can be put behind each contacting point.";
  return outcome;
}

Outcome Try138(Effort) {
  const std::string id = "thesis.2.3.138-kinds";
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
  outcome.certificates = {ListCertificate(id, AnySolids(), Faces::kAny)};
  outcome.evidence =
      "Read literally - indices in translation and rotation - there are 66 kinds, and 90, 107 or 142 with "
      "Types I and II, "
      "all motion, or both. None of the eleven readings gives 138.\n\n" +
      std::string(kMeeting) +
      "\n\nWhat does give it: see thesis.2.3.138-kinds-boxes. Three of the 142 cannot be had with "
      "axis-parallel faces, and "
      "one of the 139 others is the relation in which nothing touches.";
  return outcome;
}

Outcome TryBoxes(Effort) {
  const std::string id = "thesis.2.3.138-kinds-boxes";
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
  outcome.certificates = {ListCertificate(id, Boxes(), Faces::kAxisParallel)};
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

}  // namespace

std::vector<Claim> DofClassClaims() {
  return {{"thesis.2.3.ten-kinds",
           "By their maintaining, detaching and constraining DOFs in translation there are ten kinds of "
           "contact relations.",
           "2.3", "exhaustive", TryTenKinds},
          {"thesis.2.3.138-kinds",
           "By their maintaining, detaching and constraining DOFs in translation and rotation there are 138 "
           "kinds of "
           "non-singular contact relations.",
           "2.3", "exhaustive", Try138},
          {"thesis.2.3.138-kinds-boxes",
           "Of solids with axis-parallel faces there are 138 kinds of non-singular relations with a contact, "
           "all indices "
           "taken together.",
           "2.3, corrected", "exhaustive", TryBoxes}};
}

}  // namespace tact::provers
