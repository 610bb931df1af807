#include "robot/recognition/posed_models.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "algebra/error.h"
#include "algebra/solid/distance.h"
#include "robot/cad/mesh.h"

namespace tact::recognition {
namespace {

using algebra::Element;
using algebra::ElementKind;
using algebra::Polyhedron;
using algebra::Rational;
using algebra::Vector3;

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string Point(const Vector3& p) {
  const auto x = ToDouble(p);
  return "(" + Number(x[0]) + ", " + Number(x[1]) + ", " + Number(x[2]) + ")";
}

// The longest edge of the axis-aligned box.
double Size(const Polyhedron& solid) {
  double size = 0;
  for (int i = 0; i < 3; ++i) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (const auto& v : solid.vertices) {
      low = std::min(low, ToDouble(v.point[i]));
      high = std::max(high, ToDouble(v.point[i]));
    }
    size = std::max(size, high - low);
  }
  return size;
}

size_t CountOf(const Polyhedron& solid, ElementKind kind) {
  switch (kind) {
    case ElementKind::kVertex:
      return solid.vertices.size();
    case ElementKind::kEdge:
      return solid.edges.size();
    case ElementKind::kFace:
      return solid.faces.size();
  }
  return 0;
}

void RequireElement(const Polyhedron& solid, const Element& element, const std::string& model,
                    const std::string& where) {
  const size_t count = CountOf(solid, element.kind);
  if (element.index < count) return;
  const std::string name = ToString(element);
  throw InputError(where + ": expected an element of the " + model + " model, got " + name + "; its " +
                   name.substr(0, name.find(' ')) + " elements are 0 to " + std::to_string(count - 1));
}

bool LiesOn(const Polyhedron& solid, const Element& element, const Vector3& p,
            const Rational& squared_tolerance) {
  switch (element.kind) {
    case ElementKind::kVertex:
      return SquaredDistance(p, solid.vertices[element.index].point) <= squared_tolerance;
    case ElementKind::kEdge: {
      const auto& edge = solid.edges[element.index];
      const auto nearest =
          NearestOnSegment(p, solid.vertices[edge.tail].point, solid.vertices[edge.head].point);
      return SquaredDistance(p, nearest.point) <= squared_tolerance;
    }
    case ElementKind::kFace:
      return SquaredDistanceToFace(solid, solid.faces[element.index], p) <= squared_tolerance;
  }
  return false;
}

// Whether a plane may be that of the element: a face has but one; side is 1 for the fixed model, -1 for the moving.
bool Bears(const Polyhedron& solid, const Element& element, const Vector3& n, int side) {
  if (element.kind != ElementKind::kFace) return true;
  return Dot(solid.faces[element.index].normal, n).sign() == side;
}

}  // namespace

ModelPair LoadModels(const input::CadModels& models) {
  ModelPair pair;
  pair.unit = models.unit;
  pair.tolerance = models.tolerance;
  for (const bool moving : {true, false}) {
    const std::string path = (moving ? models.moving : models.fixed).string();
    cad::Mesh mesh = cad::ReadMesh(path, models.unit, models.unit);
    pair.notes.insert(pair.notes.end(), mesh.notes.begin(), mesh.notes.end());
    (moving ? pair.moving : pair.fixed) = std::move(mesh.solid);
  }
  const double a = Size(pair.moving), b = Size(pair.fixed);
  if (ToDouble(pair.tolerance) >= std::min(a, b)) {
    throw InputError((a <= b ? models.moving : models.fixed).string() +
                     ": expected a tolerance below the size of the model, " + Number(std::min(a, b)) + " " +
                     std::string(ToString(models.unit)) + ", got " + Number(ToDouble(pair.tolerance)) +
                     ": everything would count as contact");
  }
  if (std::max(a, b) >= 100 * std::min(a, b)) {
    const std::string unit(ToString(models.unit));
    pair.notes.push_back("the moving model is " + Number(a) + " " + unit + " long and the fixed one " +
                         Number(b) + " " + unit + ": are both files in " + unit + "?");
  }
  return pair;
}

algebra::FoundContacts ContactsInPose(const ModelPair& models, const algebra::Pose& X_FM,
                                      const std::string& where) {
  algebra::FoundContacts found = FindContacts(Transform(models.moving, X_FM), models.fixed, models.tolerance);
  if (found.penetration) {
    const std::string unit(ToString(models.unit));
    const double depth = std::sqrt(ToDouble(found.penetration->squared_depth));
    throw InputError(
        where + ": expected models that touch, got models that interpenetrate, by " + Number(depth) + " " +
        unit + " at " + Point(found.penetration->where) +
        " in the fixed model's frame; correct the pose, or allow it with a tolerance of that size");
  }
  return found;
}

algebra::ContactRelation ContactsOfElements(const ModelPair& models, const algebra::Pose& X_FM,
                                            const std::vector<input::ElementPair>& pairs,
                                            const std::string& where) {
  const algebra::FoundContacts found = ContactsInPose(models, X_FM, where);
  const Polyhedron moving = Transform(models.moving, X_FM);
  const Rational squared_tolerance = models.tolerance * models.tolerance;
  std::vector<char> wanted(found.relation.contacts.size(), 0);
  for (const input::ElementPair& pair : pairs) {
    RequireElement(moving, pair.moving, "moving", pair.where);
    RequireElement(models.fixed, pair.fixed, "fixed", pair.where);
    bool touches = false;
    for (size_t i = 0; i < wanted.size(); ++i) {
      const algebra::Contact& c = found.relation.contacts[i];
      const bool bears = std::all_of(c.planes.begin(), c.planes.end(), [&](const Vector3& n) {
        return Bears(moving, pair.moving, n, -1) && Bears(models.fixed, pair.fixed, n, 1);
      });
      if (!bears || !LiesOn(moving, pair.moving, c.point, squared_tolerance) ||
          !LiesOn(models.fixed, pair.fixed, c.point, squared_tolerance)) {
        continue;
      }
      wanted[i] = 1;
      touches = true;
    }
    if (!touches) {
      throw InputError(pair.where + ": expected elements that touch, got " + ToString(pair.moving) +
                       " of the moving model and " + ToString(pair.fixed) +
                       " of the fixed one, which do not; tact contacts lists those that do");
    }
  }
  algebra::ContactRelation relation;
  for (size_t i = 0; i < wanted.size(); ++i) {
    if (wanted[i] != 0) relation.contacts.push_back(found.relation.contacts[i]);
  }
  return relation;
}

}  // namespace tact::recognition
