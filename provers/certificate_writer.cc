#include "provers/certificate_writer.h"

#include <nlohmann/json.hpp>

#include "algebra/cone/complementary_pair.h"
#include "algebra/error.h"
#include "provers/point_json.h"

namespace tact::provers {
namespace {

using algebra::ContactRelation;
using algebra::Integer;
using algebra::MotionDof;
using algebra::Rational;
using algebra::Vector3;
using Json = nlohmann::ordered_json;

Json ToJson(const std::vector<Integer>& values) {
  Json list = Json::array();
  for (const Integer& v : values) list.push_back(WholeJson(v));
  return list;
}

Json NormalToJson(const Vector3& normal) {
  const Vector3 n = Primitive(normal);
  return ToJson(std::vector<Integer>{n.x.numerator(), n.y.numerator(), n.z.numerator()});
}

// [ (X,Y,Z) x n | W n ] of the point and the normal as written: y depends on the length of each row, so that the
// primitive rows of the engines will not do.
std::vector<Integer> WrittenRow(const Vector3& point, const Vector3& normal) {
  const Rational w(CommonDenominator(point));
  const Vector3 n = Primitive(normal), torque = Cross(w * point, n), force = w * n;
  return {torque.x.numerator(), torque.y.numerator(), torque.z.numerator(),
          force.x.numerator(),  force.y.numerator(),  force.z.numerator()};
}

Json PlanesToJson(const std::vector<Vector3>& planes) {
  Json list = Json::array();
  for (const Vector3& n : planes) list.push_back(NormalToJson(n));
  return list;
}

Json DofToJson(const MotionDof& dof) {
  const auto plain = [](const algebra::TranslationDof& d) {
    return Json{{"maintaining", d.maintaining},
                {"detaching", d.detaching},
                {"constraining", d.constraining},
                {"restricted", d.restricted}};
  };
  const algebra::RotationDof& r = dof.rotation;
  return Json{{"singular", dof.singular},
              {"translation", plain(dof.translation)},
              {"rotation",
               {{"maintaining", r.maintaining},
                {"detaching", r.detaching},
                {"detaching_type1", r.detaching_type1},
                {"detaching_type2", r.detaching_type2},
                {"constraining", r.constraining},
                {"restricted", r.restricted}}},
              {"all", plain(dof.all)}};
}

Json PairToJson(const std::vector<Integer>& rows, int columns) {
  const auto pair = algebra::FindComplementaryPair(rows, columns);
  return Json{{"x", ToJson(pair.x)}, {"y", ToJson(pair.y)}};
}

Json ContactsToJson(const std::vector<algebra::Contact>& contacts) {
  Json list = Json::array();
  for (const algebra::Contact& contact : contacts) {
    Json entry{{"point", PointJson(contact.point)}, {"planes", PlanesToJson(contact.planes)}};
    if (!contact.name.empty()) entry["name"] = contact.name;
    list.push_back(entry);
  }
  return list;
}

Json RelationToJson(const ContactRelation& relation) {
  std::vector<Integer> rows, forces;
  for (const algebra::Contact& contact : relation.contacts) {
    if (contact.singular()) continue;
    const std::vector<Integer> row = WrittenRow(contact.point, contact.planes[0]);
    rows.insert(rows.end(), row.begin(), row.end());
    forces.insert(forces.end(), row.begin() + 3, row.end());
  }
  return Json{{"contacts", ContactsToJson(relation.contacts)},
              {"all", PairToJson(rows, 6)},
              {"translation", PairToJson(forces, 3)},
              {"dof", DofToJson(algebra::ComputeMotionDof(relation))}};
}

Json Head(const std::string& claim, const std::string& kind) {
  return Json{{"format", "tact-certificate"}, {"version", 1}, {"claim", claim}, {"kind", kind}};
}

void AddAsserts(Json& certificate, const std::vector<Assertion>& asserts) {
  if (asserts.empty()) return;
  Json list = Json::array();
  for (const Assertion& assertion : asserts) {
    Json sum = Json::object();
    for (const auto& [index, coefficient] : assertion.sum) sum[index] = coefficient;
    list.push_back(Json{{"sum", sum}, {"is", assertion.is}});
  }
  certificate["asserts"] = list;
}

Certificate Finish(const std::string& name, const Json& certificate) {
  return {name, certificate.dump() + "\n"};
}

Json TransitionToJson(size_t from, const MotionDof& before, const MotionDof& after) {
  const algebra::Transition transition = AnalyzeTransition(before, after);
  Json dof_transitions = Json::array(), skills = Json::array();
  for (const auto& t : transition.dof_transitions) {
    dof_transitions.push_back(
        Json{{"motion", ToString(t.motion)}, {"from", ToString(t.from)}, {"to", ToString(t.to)}});
  }
  for (const auto skill : transition.sub_skills) skills.push_back(ToString(skill));
  return Json{{"from", from},
              {"to", from + 1},
              {"dof_transitions", dof_transitions},
              {"practical", transition.practical},
              {"sub_skills", skills},
              {"critical", transition.critical}};
}

Json BasisToJson(const std::vector<std::vector<Integer>>& vectors) {
  Json list = Json::array();
  for (const auto& v : vectors) list.push_back(ToJson(v));
  return list;
}

}  // namespace

bool Holds(const Assertion& assertion, const MotionDof& dof) {
  int sum = 0;
  for (const auto& [index, coefficient] : assertion.sum)
    sum += coefficient * (index == "constant" ? 1 : IndexValue(dof, index));
  if (assertion.is == "zero") return sum == 0;
  if (assertion.is == "nonzero") return sum != 0;
  if (assertion.is == "negative") return sum < 0;
  if (assertion.is == "positive") return sum > 0;
  if (assertion.is == "nonnegative") return sum >= 0;
  throw PreconditionError("an assertion cannot be " + assertion.is);
}

Certificate MotionDofCertificate(const std::string& name, const std::string& claim,
                                 const ContactRelation& relation, const std::vector<Assertion>& asserts) {
  Json certificate = Head(claim, "motion-dofs");
  certificate["relation"] = RelationToJson(relation);
  AddAsserts(certificate, asserts);
  return Finish(name, certificate);
}

Certificate CensusCertificate(const std::string& name, const std::string& claim,
                              const enumerators::ContactWorld& world, const std::vector<CensusClass>& classes,
                              const std::vector<Assertion>& asserts) {
  Json certificate = Head(claim, "census");
  certificate["world"] = world.sentence;
  certificate["generator"] = Json{{"contacts", ContactsToJson(world.contacts)}, {"largest", world.largest}};
  certificate["count"] = Count(world);
  Json list = Json::array();
  for (const CensusClass& c : classes)
    list.push_back(Json{{"count", c.count}, {"relation", RelationToJson(c.witness)}});
  certificate["classes"] = list;
  AddAsserts(certificate, asserts);
  return Finish(name, certificate);
}

Certificate DofClassesCertificate(const std::string& name, const std::string& claim, ClassList list,
                                  const std::vector<ContactRelation>& witnesses,
                                  const std::vector<enumerators::DofDefinition>& counted) {
  Json certificate = Head(claim, "dof-classes");
  certificate["faces"] = list == ClassList::kAxisParallelFaces ? "axis-parallel" : "any";
  Json classes = Json::array(), counts = Json::array();
  std::vector<MotionDof> dofs;
  size_t touching = 0;
  for (const ContactRelation& witness : witnesses) {
    classes.push_back(RelationToJson(witness));
    dofs.push_back(algebra::ComputeMotionDof(witness));
    touching += witness.contacts.empty() ? 0 : 1;
  }
  for (const auto& definition : counted)
    counts.push_back(Json{{"indices", definition.indices}, {"classes", CountDistinct(dofs, definition)}});
  certificate["classes"] = classes;
  certificate["counts"] = counts;
  certificate["touching"] = touching;
  if (list == ClassList::kAnyFaces) certificate["fewest"] = true;
  if (list == ClassList::kSingular) certificate["singular"] = true;
  return Finish(name, certificate);
}

Certificate TransitionsCertificate(const std::string& name, const std::string& claim,
                                   const std::vector<std::pair<std::string, ContactRelation>>& relations,
                                   const std::vector<std::pair<size_t, Changes>>& expects) {
  Json certificate = Head(claim, "transitions");
  Json names = Json::array(), list = Json::array(), steps = Json::array(), expected = Json::array();
  for (size_t i = 0; i < relations.size(); ++i) {
    names.push_back(relations[i].first);
    list.push_back(RelationToJson(relations[i].second));
    if (i + 1 < relations.size()) {
      steps.push_back(TransitionToJson(i, algebra::ComputeMotionDof(relations[i].second),
                                       algebra::ComputeMotionDof(relations[i + 1].second)));
    }
  }
  for (const auto& [transition, changes] : expects) {
    Json entry = Json::object();
    for (const auto& [index, change] : changes) entry[index] = change;
    expected.push_back(Json{{"transition", transition}, {"changes", entry}});
  }
  certificate["relations"] = list;
  certificate["names"] = names;
  certificate["transitions"] = steps;
  if (!expected.empty()) certificate["expects"] = expected;
  return Finish(name, certificate);
}

Certificate BasisCertificate(const std::string& name, const std::string& claim,
                             const std::vector<std::vector<Integer>>& vectors,
                             const std::vector<std::vector<Integer>>& reduced, int translations) {
  Json certificate = Head(claim, "basis");
  certificate["vectors"] = BasisToJson(vectors);
  certificate["reduced"] = BasisToJson(reduced);
  certificate["translations"] = translations;
  return Finish(name, certificate);
}

Certificate IllReducedEdgeCertificate(const std::string& name, const std::string& claim,
                                      const IllReducedEdge& edge) {
  Json certificate = Head(claim, "ill-reduced-singular");
  certificate["ends"] = Json::array({PointJson(edge.first), PointJson(edge.second)});
  certificate["planes"] = PlanesToJson(edge.planes);
  certificate["motion"] = ToJson(edge.motion);
  certificate["between"] = Json::array({edge.s, edge.t});
  return Finish(name, certificate);
}

}  // namespace tact::provers
