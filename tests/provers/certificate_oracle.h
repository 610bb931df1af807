/// @file
/// Whether a certificate is right, decided by the engines and plain arithmetic: what docs/certificates.md says
/// of each kind, without any code of provers/check. Numbers may be wrong here, the shape may not.
#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "algebra/contact/dof_transition.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/exact/linear_algebra.h"
#include "enumerators/contact_world.h"
#include "enumerators/dof_class.h"
#include "tests/provers/formula_oracle.h"
#include "tests/provers/knot_graph_oracle.h"
#include "tests/provers/knot_oracle.h"

namespace tact::provers::oracle {

using algebra::Integer;
using algebra::IntegerVector;
using algebra::MotionDof;
using algebra::Rational;
using algebra::Vector3;
using nlohmann::json;

inline IntegerVector Integers(const json& list) {
  IntegerVector v;
  for (const json& entry : list) {
    v.push_back(entry.is_string() ? Integer::Parse(entry.get<std::string>()).value()
                                  : Integer(entry.get<long long>()));
  }
  return v;
}

inline std::map<std::string, int> Numbers(const MotionDof& dof) {
  const auto& [t, r, a] = std::tie(dof.translation, dof.rotation, dof.all);
  return {{"translation.maintaining", t.maintaining},
          {"translation.detaching", t.detaching},
          {"translation.constraining", t.constraining},
          {"translation.restricted", t.restricted},
          {"rotation.maintaining", r.maintaining},
          {"rotation.detaching", r.detaching},
          {"rotation.detaching_type1", r.detaching_type1},
          {"rotation.detaching_type2", r.detaching_type2},
          {"rotation.constraining", r.constraining},
          {"rotation.restricted", r.restricted},
          {"all.maintaining", a.maintaining},
          {"all.detaching", a.detaching},
          {"all.constraining", a.constraining},
          {"all.restricted", a.restricted}};
}

/// Empty if W is not positive.
inline std::optional<Vector3> Point(const json& written) {
  const IntegerVector p = Integers(written);
  if (p[3].sign() <= 0) return std::nullopt;
  return Vector3{Rational(p[0], p[3]), Rational(p[1], p[3]), Rational(p[2], p[3])};
}

inline Vector3 Normal(const json& written) {
  const IntegerVector n = Integers(written);
  return {Rational(n[0]), Rational(n[1]), Rational(n[2])};
}

/// Empty if a contact is none.
inline std::optional<std::vector<algebra::Contact>> Contacts(const json& list) {
  std::vector<algebra::Contact> contacts;
  for (const json& contact : list) {
    const auto point = Point(contact["point"]);
    if (!point) return std::nullopt;
    contacts.push_back({*point, {}, ""});
    for (const json& plane : contact["planes"]) contacts.back().planes.push_back(Normal(plane));
    for (const Vector3& n : contacts.back().planes) {
      if (n.IsZero()) return std::nullopt;
    }
  }
  return contacts;
}

/// The rows of the contacts with one plane as written; of their columns, those from `first` on.
inline std::vector<IntegerVector> WrittenRows(const json& contacts, size_t first) {
  std::vector<IntegerVector> rows;
  for (const json& contact : contacts) {
    if (contact["planes"].size() != 1) continue;
    const IntegerVector p = Integers(contact["point"]), n = Integers(contact["planes"][0]);
    const IntegerVector row = {p[1] * n[2] - p[2] * n[1],
                               p[2] * n[0] - p[0] * n[2],
                               p[0] * n[1] - p[1] * n[0],
                               p[3] * n[0],
                               p[3] * n[1],
                               p[3] * n[2]};
    rows.emplace_back(row.begin() + static_cast<long>(first), row.end());
  }
  return rows;
}

inline bool IsStrictlyComplementary(const json& pair, const std::vector<IntegerVector>& rows,
                                    size_t columns) {
  const IntegerVector x = Integers(pair["x"]), y = Integers(pair["y"]);
  IntegerVector sum(columns, Integer(0));
  for (size_t i = 0; i < rows.size(); ++i) {
    Integer product(0);
    for (size_t j = 0; j < columns; ++j) {
      product += rows[i][j] * x[j];
      sum[j] += y[i] * rows[i][j];
    }
    if (product.sign() < 0 || y[i].sign() < 0 || (product.sign() > 0) == (y[i].sign() > 0)) return false;
  }
  return sum == IntegerVector(columns, Integer(0));
}

/// The engine's motion DOFs, if the contacts, the evidence and "dof" agree with them.
inline std::optional<MotionDof> RightRelation(const json& relation) {
  const auto contacts = Contacts(relation["contacts"]);
  if (!contacts) return std::nullopt;
  if (!IsStrictlyComplementary(relation["all"], WrittenRows(relation["contacts"], 0), 6)) return std::nullopt;
  if (!IsStrictlyComplementary(relation["translation"], WrittenRows(relation["contacts"], 3), 3))
    return std::nullopt;
  const MotionDof dof = algebra::ComputeMotionDof({*contacts});
  if (relation["dof"]["singular"] != dof.singular) return std::nullopt;
  for (const auto& [name, value] : Numbers(dof)) {
    const size_t dot = name.find('.');
    if (relation["dof"][name.substr(0, dot)][name.substr(dot + 1)] != value) return std::nullopt;
  }
  return dof;
}

inline bool AssertsHold(const json& certificate, const MotionDof& dof) {
  std::map<std::string, int> numbers = Numbers(dof);
  numbers["constant"] = 1;
  for (const json& assertion : certificate.value("asserts", json::array())) {
    long long sum = 0;
    for (const auto& [name, coefficient] : assertion["sum"].items())
      sum += coefficient.get<long long>() * numbers.at(name);
    const std::map<std::string, bool> is = {{"zero", sum == 0},
                                            {"nonzero", sum != 0},
                                            {"negative", sum < 0},
                                            {"positive", sum > 0},
                                            {"nonnegative", sum >= 0}};
    if (!is.at(assertion["is"])) return false;
  }
  return true;
}

using Counts = std::map<MotionDof, long long>;

/// The members of every class of a generator's world, by the enumerator and the engine; kept for the next call.
inline const Counts& Enumerate(const json& generator, const enumerators::ContactWorld& world) {
  static std::map<std::string, Counts> known;
  const auto [entry, is_new] = known.try_emplace(generator.dump());
  if (is_new) {
    algebra::MotionDofEngine engine;
    ForEachRelation(world, [&](const auto& relation) { ++entry->second[engine.Compute(relation)]; });
  }
  return entry->second;
}

inline json WithoutName(const json& contact) { return json::array({contact["point"], contact["planes"]}); }

inline bool GeneratorIsRight(const json& c, const Counts& claimed) {
  const json& generator = c["generator"];
  const long long largest = generator["largest"];
  const auto contacts = Contacts(generator["contacts"]);
  if (!contacts || largest < 0 || largest > 64) return false;
  std::set<json> written;
  for (const json& contact : generator["contacts"]) written.insert(WithoutName(contact));
  if (written.size() != contacts->size()) return false;
  Integer count(1);
  for (long long k = 0; k < largest; ++k)
    count = DivideExactly(count * Integer(static_cast<long long>(contacts->size()) + k + 1), Integer(k + 1));
  if (count != Integer(c["count"].get<long long>())) return false;
  for (const json& one : c["classes"]) {
    const json& witness = one["relation"]["contacts"];
    if (static_cast<long long>(witness.size()) > largest) return false;
    for (const json& contact : witness) {
      if (!written.contains(WithoutName(contact))) return false;
    }
  }
  return Enumerate(generator, {"", *contacts, static_cast<size_t>(largest)}) == claimed;
}

inline bool CensusIsRight(const json& c) {
  Counts claimed;
  long long members = 0;
  for (const json& one : c["classes"]) {
    const auto dof = RightRelation(one["relation"]);
    const long long count = one["count"];
    if (!dof || count <= 0 || !AssertsHold(c, *dof) || !claimed.emplace(*dof, count).second) return false;
    members += count;
  }
  return !claimed.empty() && members == c["count"] && GeneratorIsRight(c, claimed);
}

/// The six indices of both motions and the restricted DOFs, by the names that "changes" uses.
inline std::map<std::string, int> TransitionNumbers(const MotionDof& dof) {
  std::map<std::string, int> numbers;
  for (const auto motion : {algebra::Motion::kTranslation, algebra::Motion::kRotation}) {
    for (int i = 0; i < algebra::kDofIndices; ++i) {
      numbers[ToString(motion) + "." + ToString(static_cast<algebra::DofIndex>(i))] = Indices(dof, motion)[i];
    }
    numbers[ToString(motion) + ".restricted"] = Restricted(dof, motion);
  }
  return numbers;
}

inline bool TransitionsAreRight(const json& c) {
  std::vector<MotionDof> dofs;
  for (const json& relation : c["relations"]) {
    const auto dof = RightRelation(relation);
    if (!dof) return false;
    dofs.push_back(*dof);
  }
  const auto is_index = [](long long i, size_t size) { return i >= 0 && i < static_cast<long long>(size); };
  for (const json& t : c["transitions"]) {
    if (!is_index(t["from"], dofs.size()) || !is_index(t["to"], dofs.size())) return false;
    const auto seen = algebra::AnalyzeTransition(dofs[t["from"]], dofs[t["to"]]);
    json list = json::array(), skills = json::array();
    for (const auto& d : seen.dof_transitions)
      list.push_back({{"motion", ToString(d.motion)}, {"from", ToString(d.from)}, {"to", ToString(d.to)}});
    for (const auto skill : seen.sub_skills) skills.push_back(ToString(skill));
    if (t["dof_transitions"] != list || t["sub_skills"] != skills || t["practical"] != seen.practical ||
        t["critical"] != seen.critical) {
      return false;
    }
  }
  for (const json& expect : c.value("expects", json::array())) {
    if (!is_index(expect["transition"], c["transitions"].size())) return false;
    const json& t = c["transitions"][expect["transition"].get<size_t>()];
    const auto before = TransitionNumbers(dofs[t["from"]]), after = TransitionNumbers(dofs[t["to"]]);
    for (const auto& [name, change] : expect["changes"].items()) {
      if (change != after.at(name) - before.at(name)) return false;
    }
  }
  return true;
}

inline algebra::IntegerMatrix Matrix(const json& rows, size_t columns) {
  algebra::IntegerMatrix matrix(0, columns);
  for (const json& row : rows) {
    const IntegerVector v = Integers(row);
    matrix.AppendRow(std::span(v).first(columns));
  }
  return matrix;
}

inline bool BasisIsRight(const json& c) {
  const algebra::IntegerMatrix vectors = Matrix(c["vectors"], 6), reduced = Matrix(c["reduced"], 6);
  if (Rank(vectors) != vectors.rows || Rank(reduced) != reduced.rows) return false;
  if (RowSpace(vectors).vectors != RowSpace(reduced).vectors) return false;
  const algebra::IntegerMatrix angular = Matrix(c["reduced"], 3);
  long long turning = 0;
  for (size_t i = 0; i < angular.rows; ++i) turning += angular.IsZeroRow(i) ? 0 : 1;
  return static_cast<long long>(Rank(angular)) == turning &&
         c["translations"] == static_cast<long long>(reduced.rows) - turning;
}

inline bool IllReducedIsRight(const json& c) {
  const auto p = Point(c["ends"][0]), q = Point(c["ends"][1]);
  const IntegerVector between = Integers(c["between"]), motion = Integers(c["motion"]);
  if (!p || !q || between[0].sign() <= 0 || between[1].sign() <= 0) return false;
  const Vector3 w{Rational(motion[0]), Rational(motion[1]), Rational(motion[2])};
  const Vector3 v{Rational(motion[3]), Rational(motion[4]), Rational(motion[5])};
  const Rational share(between[0], between[0] + between[1]);
  const Vector3 middle = share * *p + (Rational(1) - share) * *q;
  bool first = false, second = false;
  for (const json& written : c["planes"]) {
    const Vector3 n = Normal(written);
    const auto leaves = [&](const Vector3& at) { return Dot(n, v + Cross(w, at)).sign() >= 0; };
    if (n.IsZero() || Dot(n, *q - *p).sign() != 0 || leaves(middle)) return false;
    first = first || leaves(*p);
    second = second || leaves(*q);
  }
  return first && second;
}

inline bool IsAxisParallel(const json& relation) {
  for (const json& contact : relation["contacts"]) {
    for (const json& plane : contact["planes"]) {
      if (std::count(plane.begin(), plane.end(), 0) != 2) return false;
    }
  }
  return true;
}

inline bool DofClassesAreRight(const json& c) {
  const bool boxes = c["faces"] == "axis-parallel", singular = c.value("singular", false);
  if (singular && (boxes || c.value("fewest", false))) return false;
  const auto classes = boxes      ? enumerators::BoxClasses()
                       : singular ? enumerators::SingularClasses()
                                  : enumerators::DofClasses();
  std::set<MotionDof> seen;
  size_t touching = 0;
  for (const json& relation : c["classes"]) {
    const auto dof = RightRelation(relation);
    if (!dof || dof->singular != singular || !seen.insert(*dof).second ||
        (boxes && !IsAxisParallel(relation)))
      return false;
    const size_t contacts = relation["contacts"].size();
    if (c.value("fewest", false) && contacts != enumerators::FewestContacts(*dof)) return false;
    touching += contacts > 0 ? 1 : 0;
  }
  if (std::vector<MotionDof>(seen.begin(), seen.end()) != classes || c["touching"] != touching) return false;
  for (const json& entry : c["counts"]) {
    if (entry["classes"] != enumerators::CountDistinct(classes, {"", entry["indices"]})) return false;
  }
  return true;
}

/// In path_oracle.h.
inline bool PathIsRight(const json& c);

inline bool IsRight(const json& c) {
  if (c["version"] != 1) return false;
  const std::string kind = c["kind"];
  if (kind == "dof-classes") return DofClassesAreRight(c);
  if (kind == "census") return CensusIsRight(c);
  if (kind == "transitions") return TransitionsAreRight(c);
  if (kind == "basis") return BasisIsRight(c);
  if (kind == "ill-reduced-singular") return IllReducedIsRight(c);
  if (kind == "motion-path") return PathIsRight(c);
  if (kind == "knot-move") return KnotMoveIsRight(c);
  if (kind == "knot-rule") return KnotRuleIsRight(c);
  if (kind == "knot-tying") return TyingIsRight(c);
  if (kind == "knot-parts" || kind == "knot-embedding" || kind == "knot-face-search" ||
      kind == "knot-subdivision")
    return KnotGraphIsRight(c);
  if (kind == "identity") return IdentityIsRight(c);
  if (kind == "no-identity") return NoIdentityIsRight(c);
  if (kind != "motion-dofs") return false;
  const auto dof = RightRelation(c["relation"]);
  return dof && AssertsHold(c, *dof);
}

}  // namespace tact::provers::oracle

#include "tests/provers/path_oracle.h"
