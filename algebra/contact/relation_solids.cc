#include "algebra/contact/relation_solids.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/error.h"
#include "algebra/solid/convex_hull.h"
#include "algebra/solid/half_space_polytope.h"

namespace tact::algebra {
namespace {

const Rational kHalf = Rational(1) / Rational(2);

// The walls { x | n . x >= bound } by normal, and the contacts slid onto them.
struct Cavity {
  std::map<Vector3, Rational> bounds;
  std::vector<Contact> contacts;
};

ContactRelation WithPrimitiveNormals(ContactRelation relation) {
  for (Contact& contact : relation.contacts) {
    if (contact.planes.size() != 1 || contact.planes.front().IsZero()) {
      throw PreconditionError(
          "RealizeRelation: expected contacts with one plane whose normal is not zero, got " +
          std::to_string(contact.planes.size()) + " planes at " + ToString(contact.point));
    }
    contact.planes.front() = Primitive(contact.planes.front());
  }
  return relation;
}

// The part of v at right angles to n.
Vector3 Across(const Vector3& n, const Vector3& v) { return v - Dot(n, v) / Dot(n, n) * n; }

// The smallest power of two that is at least x; precondition: x > 0.
Rational PowerOfTwoFrom(const Rational& x) {
  Rational power = 1;
  while (power < x) power *= 2;
  while (kHalf * power >= x) power *= kHalf;
  return power;
}

// The largest integer whose square is at most x; precondition: x >= 0.
Integer FloorOfRoot(const Rational& x) {
  std::vector<Integer> bits = {1};
  while (Rational(bits.back() * bits.back()) <= x) bits.push_back(bits.back() * Integer(2));
  Integer root = 0;
  for (auto bit = bits.rbegin(); bit != bits.rend(); ++bit) {
    const Integer next = root + *bit;
    if (Rational(next * next) <= x) root = next;
  }
  return root;
}

// The multiple of the step next to x toward zero.
Rational Truncate(const Rational& x, const Rational& step) {
  const Rational steps = x / step;
  const Rational magnitude = step * Rational(FloorOfRoot(steps * steps));
  return x.sign() < 0 ? -magnitude : magnitude;
}

// The point for which the squared distances to the lines of action, and a little of those to the points, have
// the least sum: the points alone may be anywhere on their lines.
Vector3 PointNearLinesOfAction(const ContactRelation& relation) {
  const Rational little = Rational(1) / Rational(16);
  const std::array<Vector3, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::array<Vector3, 3> rows;  // a symmetric, positive definite system
  Vector3 right;
  for (const Contact& contact : relation.contacts) {
    const Vector3& n = contact.planes.front();
    for (int i = 0; i < 3; ++i) rows[i] = rows[i] + Across(n, axes[i]) + little * axes[i];
    right = right + Across(n, contact.point) + little * contact.point;
  }
  const Vector3 bc = Cross(rows[1], rows[2]), ca = Cross(rows[2], rows[0]), ab = Cross(rows[0], rows[1]);
  return Rational(1) / Dot(rows[0], bc) * (right.x * bc + right.y * ca + right.z * ab);
}

struct Frame {
  Vector3 centre;
  Rational size = 1;  // of the lines' distances from the centre
};

Frame FrameOf(const ContactRelation& relation) {
  Frame frame;
  if (relation.contacts.empty()) return frame;
  frame.centre = PointNearLinesOfAction(relation);
  Rational most;
  for (const Contact& contact : relation.contacts) {
    const Vector3 offset = Across(contact.planes.front(), contact.point - frame.centre);
    for (int i = 0; i < 3; ++i) most = std::max(most, Abs(offset[i]));
  }
  if (most.sign() == 0) return frame;
  frame.size = PowerOfTwoFrom(most);
  for (int i = 0; i < 3; ++i) frame.centre[i] = Truncate(frame.centre[i], frame.size / 16);
  return frame;
}

// The walls' distances from the centre are above T by a step's length or two at most.
Cavity SlideOntoWalls(const ContactRelation& relation, const Frame& frame, const Rational& T) {
  const Rational step = frame.size / 8;
  Cavity cavity;
  for (Contact contact : relation.contacts) {
    const Vector3& n = contact.planes.front();
    const Rational largest = std::max({Abs(n.x), Abs(n.y), Abs(n.z)});
    const Rational steps = Rational(FloorOfRoot(T * T / (step * step) * Dot(n, n) / (largest * largest))) + 1;
    const Rational bound = Dot(n, frame.centre) - step * steps * largest;
    contact.point = contact.point + (bound - Dot(n, contact.point)) / Dot(n, n) * n;
    cavity.bounds.emplace(n, bound);
    cavity.contacts.push_back(std::move(contact));
  }
  return cavity;
}

bool EachTouchesItsWallAlone(const Cavity& cavity) {
  return std::ranges::all_of(cavity.contacts, [&](const Contact& contact) {
    return std::ranges::all_of(cavity.bounds, [&](const auto& wall) {
      return wall.first == contact.planes.front() || Dot(wall.first, contact.point) > wall.second;
    });
  });
}

// The corners of a box, those of the lowest x first.
std::vector<Vector3> BoxCorners(const Vector3& low, const Vector3& high) {
  std::vector<Vector3> corners;
  for (const Rational& x : {low.x, high.x}) {
    for (const Rational& y : {low.y, high.y}) {
      for (const Rational& z : {low.z, high.z}) corners.push_back({x, y, z});
    }
  }
  return corners;
}

Polyhedron Cage(const Cavity& cavity, Vector3 low, Vector3 high, const Rational& T) {
  const Vector3 room = T / 4 * Vector3{1, 1, 1};
  low = low - room;
  high = high + room;
  std::vector<std::pair<Vector3, Rational>> inside;
  for (const auto& [n, bound] : cavity.bounds) inside.emplace_back(-n, -bound);
  for (int i = 0; i < 3; ++i) {
    Vector3 axis;
    axis[i] = 1;
    inside.emplace_back(axis, high[i]);
    inside.emplace_back(-axis, -low[i]);
  }
  PolygonSoup cage = ConvexHull(BoxCorners(low - room, high + room));
  const PolygonSoup hole = HalfSpacePolytope(inside);
  const size_t first = cage.points.size();
  cage.points.insert(cage.points.end(), hole.points.begin(), hole.points.end());
  for (const std::vector<size_t>& polygon : hole.polygons) {
    std::vector<size_t>& turned = cage.polygons.emplace_back();
    for (auto corner = polygon.rbegin(); corner != polygon.rend(); ++corner)
      turned.push_back(first + *corner);
  }
  return BuildPolyhedron(cage);
}

using Touch = std::pair<Vector3, Vector3>;

std::vector<Touch> Touches(const ContactRelation& relation) {
  std::vector<Touch> touches;
  for (const Contact& contact : relation.contacts) {
    for (const Vector3& n : contact.planes) touches.emplace_back(contact.point, Primitive(n));
  }
  std::ranges::sort(touches);
  return touches;
}

void Verify(const RelationSolids& solids, const ContactRelation& wanted) {
  const FoundContacts found = FindContacts(solids.moving, solids.fixed, 0);
  if (found.penetration) {
    throw InvariantError("RealizeRelation: expected solids that touch, got ones that penetrate at " +
                         ToString(found.penetration->where));
  }
  if (found.relation.singular() || Touches(found.relation) != Touches(solids.relation)) {
    throw InvariantError("RealizeRelation: expected solids that touch in " +
                         std::to_string(solids.relation.contacts.size()) + " given contacts, got " +
                         std::to_string(found.relation.contacts.size()) + " contacts or others");
  }
  if (ComputeMotionDof(solids.relation) != ComputeMotionDof(wanted)) {
    throw InvariantError("RealizeRelation: expected the motion DOFs of the relation given, got others");
  }
}

}  // namespace

RelationSolids RealizeRelation(const ContactRelation& relation) {
  const ContactRelation wanted = WithPrimitiveNormals(relation);
  const Frame frame = FrameOf(wanted);
  Rational T = frame.size;
  Cavity cavity = SlideOntoWalls(wanted, frame, T);
  while (!EachTouchesItsWallAlone(cavity)) {
    T *= 2;
    cavity = SlideOntoWalls(wanted, frame, T);
  }
  std::vector<Vector3> points;
  for (const Contact& contact : cavity.contacts) points.push_back(contact.point);
  const Vector3 half = T / 2 * Vector3{1, 1, 1};
  for (const Vector3& corner : BoxCorners(frame.centre - half, frame.centre + half)) points.push_back(corner);
  const PolygonSoup block = ConvexHull(points);

  Vector3 low = block.points.front(), high = low;
  for (const Vector3& p : block.points) {
    for (int i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  RelationSolids solids{BuildPolyhedron(block), Cage(cavity, low, high, T), {}};
  std::set<Vector3> corners(block.points.begin(), block.points.end());
  for (Contact& contact : cavity.contacts) {
    if (corners.erase(contact.point) > 0) solids.relation.contacts.push_back(std::move(contact));
  }
  Verify(solids, wanted);
  return solids;
}

}  // namespace tact::algebra
