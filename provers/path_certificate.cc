#include "provers/path_certificate.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "algebra/contact/path_separation.h"
#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"
#include "provers/point_json.h"

namespace tact::provers {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::PathPlane;
using algebra::PolygonSoup;
using algebra::Polyhedron;
using algebra::Rational;
using algebra::Scene;
using algebra::Vector3;
using Json = nlohmann::ordered_json;

Json FractionToJson(const Rational& s) {
  return Json::array({WholeJson(s.numerator()), WholeJson(s.denominator())});
}

Json PiecesToJson(const std::vector<PolygonSoup>& hulls) {
  Json list = Json::array();
  for (const PolygonSoup& hull : hulls) {
    Json corners = Json::array();
    for (const Vector3& p : hull.points) corners.push_back(PointJson(p));
    list.push_back(corners);
  }
  return list;
}

Json PathToJson(const algebra::MotionPath& path) {
  if (path.kind == algebra::MotionPath::Kind::kLine) return Json{{"line", PointJson(path.vector)}};
  return Json{{"rotation", {{"point", PointJson(path.center)}, {"axis", PointJson(path.vector)}}}};
}

Json PlaneToJson(const PathPlane& plane) {
  const bool carried = plane.kind == PathPlane::Kind::kCarried;
  Json json{{"until", FractionToJson(plane.until)},
            {"through", {{carried ? "moving" : "fixed", plane.corner}}}};
  if (plane.kind == PathPlane::Kind::kEdges) {
    json["edges"] = Json::array({Json(plane.moving_edge), Json(plane.fixed_edge)});
  } else {
    const Vector3 n = Primitive(plane.normal);
    json[carried ? "carried" : "normal"] =
        Json::array({WholeJson(n.x.numerator()), WholeJson(n.y.numerator()), WholeJson(n.z.numerator())});
  }
  return json;
}

std::vector<PolygonSoup> HullsOf(const std::vector<std::vector<Vector3>>& pieces) {
  std::vector<PolygonSoup> hulls;
  for (const auto& piece : pieces) hulls.push_back(algebra::ConvexHull(piece));
  return hulls;
}

using PointAndPlanes = std::pair<Vector3, std::set<Vector3>>;
using Contacts = std::set<PointAndPlanes>;

PointAndPlanes Bare(const Contact& contact) {
  std::set<Vector3> planes;
  for (const Vector3& n : contact.planes) planes.insert(Primitive(n));
  return {contact.point, planes};
}

// The contacts of each moving piece with each fixed one; one with more planes than another at its point is left
// out.
Contacts ContactsOfPieces(const std::vector<PolygonSoup>& moving, const std::vector<PolygonSoup>& fixed,
                          const algebra::Pose& X) {
  Contacts all, kept;
  std::vector<Polyhedron> standing;
  for (const PolygonSoup& hull : fixed) standing.push_back(BuildPolyhedron(hull));
  for (const PolygonSoup& hull : moving) {
    const Polyhedron piece = Transform(BuildPolyhedron(hull), X);
    for (const Polyhedron& other : standing) {
      for (const Contact& contact : FindContacts(piece, other, 0).relation.contacts)
        all.insert(Bare(contact));
    }
  }
  for (const PointAndPlanes& one : all) {
    const auto& planes = one.second;
    const bool implied = std::any_of(all.begin(), all.end(), [&](const PointAndPlanes& other) {
      return other.first == one.first && other.second.size() < planes.size() &&
             std::includes(planes.begin(), planes.end(), other.second.begin(), other.second.end());
    });
    if (!implied) kept.insert(one);
  }
  return kept;
}

void RefuseSeams(const ContactRelation& relation, const Contacts& of_pieces, const Rational& s) {
  Contacts of_solids, differ;
  for (const Contact& contact : relation.contacts) of_solids.insert(Bare(contact));
  std::set_symmetric_difference(of_solids.begin(), of_solids.end(), of_pieces.begin(), of_pieces.end(),
                                std::inserter(differ, differ.end()));
  if (differ.empty()) return;
  throw PreconditionError("at s = " + s.ToString() + " the contact at " + ToString(differ.begin()->first) +
                          " is at a seam of pieces, whose separate planes are not the whole solid's: cut the "
                          "solid into other pieces");
}

}  // namespace

Certificate PathCertificate(const std::string& name, const std::string& claim, const Scene& scene,
                            PathDirection direction, const Changes& expects) {
  const algebra::PathContacts path = FollowScene(scene);
  if (path.event) throw PreconditionError("no path for a certificate: " + path.event->what);
  if (ComputeMotionDof(path.start.relation) != ComputeMotionDof(path.middle.relation))
    throw PreconditionError("no path for a certificate: the motion DOFs at s = 0 and s = 1/2 differ");
  const auto moving = HullsOf(scene.moving_pieces), fixed = HullsOf(scene.fixed_pieces);
  const std::vector<Rational> at = {0, Rational(1, 2), 1};
  const algebra::FoundContacts* const found[] = {&path.start, &path.middle, &path.end};
  std::vector<std::pair<std::string, ContactRelation>> relations;
  Json places = Json::array();
  for (size_t i = 0; i < at.size(); ++i) {
    RefuseSeams(found[i]->relation, ContactsOfPieces(moving, fixed, scene.path.At(at[i])), at[i]);
    relations.emplace_back("at s = " + at[i].ToString(), found[i]->relation);
    places.push_back(FractionToJson(at[i]));
  }
  const bool back = direction == PathDirection::kBack;
  if (back) {
    std::reverse(relations.begin(), relations.end());
    std::reverse(places.begin(), places.end());
  }
  std::vector<std::pair<size_t, Changes>> expected;
  if (!expects.empty()) expected.emplace_back(back ? 0 : 1, expects);

  Json certificate = Json::parse(TransitionsCertificate(name, claim, relations, expected).json);
  certificate["kind"] = "motion-path";
  certificate["moving"] = PiecesToJson(moving);
  certificate["fixed"] = PiecesToJson(fixed);
  certificate["path"] = PathToJson(scene.path);
  certificate["at"] = places;
  Json planes = Json::array();
  for (const PolygonSoup& one : moving) {
    Json row = Json::array();
    for (const PolygonSoup& other : fixed) {
      Json list = Json::array();
      for (const PathPlane& plane : SeparateAlong(one, other, scene.path)) list.push_back(PlaneToJson(plane));
      row.push_back(list);
    }
    planes.push_back(row);
  }
  certificate["planes"] = planes;
  return {name, certificate.dump() + "\n"};
}

}  // namespace tact::provers
