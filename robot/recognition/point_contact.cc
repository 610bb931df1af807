#include "robot/recognition/point_contact.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "algebra/exact/rational.h"

namespace tact::recognition {
namespace {

using algebra::Element;
using algebra::ElementKind;
using algebra::Polyhedron;
using algebra::Vector3;
using joint::Transform;

constexpr double kParallel = 1e-12;  // sine of the angle between two edges' directions

std::vector<size_t> VerticesAt(const Element& element) {
  return element.kind == ElementKind::kVertex ? std::vector<size_t>{element.index} : std::vector<size_t>{};
}

std::vector<size_t> EdgesAt(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kVertex) return solid.vertices[element.index].edges;
  return element.kind == ElementKind::kEdge ? std::vector<size_t>{element.index} : std::vector<size_t>{};
}

std::vector<size_t> FacesAt(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kVertex) return solid.vertices[element.index].faces;
  if (element.kind == ElementKind::kFace) return {element.index};
  return {solid.edges[element.index].left, solid.edges[element.index].right};
}

Vector3 Along(const Polyhedron& solid, size_t edge) {
  const algebra::Edge& e = solid.edges[edge];
  return solid.vertices[e.head].point - solid.vertices[e.tail].point;
}

bool PointTheSameWay(const Vector3& a, const Vector3& b) {
  return Cross(a, b).IsZero() && Dot(a, b).sign() > 0;
}

Eigen::Vector3d Double(const Vector3& v) { return {ToDouble(v.x), ToDouble(v.y), ToDouble(v.z)}; }

Gap At(const Eigen::Vector3d& point, const Eigen::Vector3d& normal, double gap) {
  Gap answer{gap, {}, point};
  answer.row << point.cross(normal).transpose(), normal.transpose();
  return answer;
}

Gap EdgeGap(const PointContact& contact, const SolidF& moving, const SolidF& fixed, const Transform& X_FM) {
  const auto& m = moving.edges[contact.moving];
  const auto& f = fixed.edges[contact.fixed];
  const Eigen::Vector3d a = X_FM * m.tail, e = (X_FM.R * (m.head - m.tail)).normalized();
  const Eigen::Vector3d g = (f.head - f.tail).normalized(), apart = a - f.tail;
  const Eigen::Vector3d cross = e.cross(g);
  const double sine = cross.norm();
  if (sine < kParallel) {
    const Eigen::Vector3d across = apart - apart.dot(g) * g;
    const double distance = across.norm();
    return At(a, distance > 0 ? Eigen::Vector3d(across / distance) : g.unitOrthogonal(), distance);
  }
  const Eigen::Vector3d n = contact.orientation * cross / sine;
  const double along = -apart.cross(g).dot(cross) / (sine * sine);
  return At(a + along * e, n, n.dot(apart));
}

}  // namespace

std::string ToString(const PointContact& contact) {
  const bool edges = contact.kind == PointContactKind::kEdgeEdge;
  const char* moving = edges ? "edge " : contact.kind == PointContactKind::kVertexFace ? "vertex " : "face ";
  const char* fixed = edges ? "edge " : contact.kind == PointContactKind::kVertexFace ? "face " : "vertex ";
  return moving + std::to_string(contact.moving) + " on " + fixed + std::to_string(contact.fixed);
}

std::vector<PointContact> PointContactsOf(const algebra::FoundContacts& found, const Polyhedron& moving,
                                          const Polyhedron& fixed) {
  std::set<PointContact> all;
  for (size_t i = 0; i < found.relation.contacts.size(); ++i) {
    const auto& [m, f] = found.elements[i];
    for (const Vector3& plane : found.relation.contacts[i].planes) {
      bool has_face = false;
      for (const size_t face : FacesAt(fixed, f)) {
        if (!PointTheSameWay(fixed.faces[face].normal, plane)) continue;
        for (const size_t vertex : VerticesAt(m)) {
          all.insert({PointContactKind::kVertexFace, vertex, face});
          has_face = true;
        }
      }
      for (const size_t face : FacesAt(moving, m)) {
        if (!PointTheSameWay(-moving.faces[face].normal, plane)) continue;
        for (const size_t vertex : VerticesAt(f)) {
          all.insert({PointContactKind::kFaceVertex, face, vertex});
          has_face = true;
        }
      }
      if (has_face) continue;
      for (const size_t e : EdgesAt(moving, m)) {
        for (const size_t g : EdgesAt(fixed, f)) {
          const Vector3 cross = Cross(Along(moving, e), Along(fixed, g));
          if (PointTheSameWay(cross, plane)) all.insert({PointContactKind::kEdgeEdge, e, g, 1});
          if (PointTheSameWay(-cross, plane)) all.insert({PointContactKind::kEdgeEdge, e, g, -1});
        }
      }
    }
  }
  return {all.begin(), all.end()};
}

SolidF ToDouble(const Polyhedron& solid) {
  SolidF answer;
  for (const auto& vertex : solid.vertices) answer.vertices.push_back(Double(vertex.point));
  for (const auto& edge : solid.edges)
    answer.edges.push_back({answer.vertices[edge.tail], answer.vertices[edge.head]});
  for (const auto& face : solid.faces) {
    const Eigen::Vector3d normal = Double(face.normal);
    answer.faces.push_back({normal / normal.norm(), ToDouble(face.offset) / normal.norm()});
  }
  return answer;
}

Gap GapOf(const PointContact& contact, const SolidF& moving, const SolidF& fixed, const Transform& X_FM) {
  switch (contact.kind) {
    case PointContactKind::kVertexFace: {
      const auto& face = fixed.faces[contact.fixed];
      const Eigen::Vector3d at = X_FM * moving.vertices[contact.moving];
      return At(at, face.normal, face.normal.dot(at) - face.offset);
    }
    case PointContactKind::kFaceVertex: {
      const auto& face = moving.faces[contact.moving];
      const Eigen::Vector3d at = fixed.vertices[contact.fixed], n = X_FM.R * face.normal;
      return At(at, -n, n.dot(at - X_FM.p) - face.offset);
    }
    default:
      return EdgeGap(contact, moving, fixed, X_FM);
  }
}

}  // namespace tact::recognition
