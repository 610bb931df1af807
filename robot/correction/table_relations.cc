#include "robot/correction/table_relations.h"

#include "algebra/error.h"

namespace tact::correction {
namespace {

using algebra::PolygonSoup;
using algebra::Polyhedron;
using algebra::Pose;
using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

constexpr int kHalfWidth = 15, kHalfDepth = 20, kHeight = 80;  // of the peg; its origin is in its middle
constexpr int kSlotDepth = 60, kWide = 45, kFitting = 2 * kHalfWidth;

struct Flat {
  Rational x, z;
};

// A polygon in the xz-plane, counter-clockwise with z up and x to the right, drawn out along y.
Polyhedron Drawn(const std::vector<Flat>& profile, int from, int to) {
  PolygonSoup soup;
  const size_t count = profile.size();
  for (const int y : {from, to})
    for (const Flat& p : profile) soup.points.push_back({p.x, Rational(y), p.z});
  std::vector<size_t> front, back;
  for (size_t i = 0; i < count; ++i) {
    front.push_back(i);
    back.push_back(2 * count - 1 - i);
    const size_t next = (i + 1) % count;
    soup.polygons.push_back({next, i, count + i, count + next});
  }
  soup.polygons.push_back(front);
  soup.polygons.push_back(back);
  return BuildPolyhedron(soup);
}

Polyhedron Peg() {
  const Rational x = kHalfWidth, z = Rational(kHeight) / 2;
  return Drawn({{-x, -z}, {x, -z}, {x, z}, {-x, z}}, -kHalfDepth, kHalfDepth);
}

// Its top is z = 0, the slot's left wall x = 0.
Polyhedron Block(int slot_width) {
  return Drawn({{-80, -80},
                {slot_width + 80, -80},
                {slot_width + 80, 0},
                {slot_width, 0},
                {slot_width, -kSlotDepth},
                {0, -kSlotDepth},
                {0, 0},
                {-80, 0}},
               -80, 80);
}

// Turned about y by twice the angle whose tangent is `tangent`, so that the peg's point p comes to lie at q.
Pose Placed(const Rational& tangent, const Vector3& p, const Vector3& q) {
  const Rotation R = Rotation::FromQuaternion(1, 0, tangent, 0);
  return {R, q - R * p};
}

TableRelation Make(const std::string& name, int slot_width, const Pose& realisation) {
  TableRelation table{name, Peg(), Block(slot_width), realisation, {}};
  table.found = FindContacts(Transform(table.moving, realisation), table.fixed, 0);
  if (table.found.penetration) throw InvariantError("table relation " + name + ": penetrates");
  return table;
}

}  // namespace

TableRelation TableRelationNamed(const std::string& name) {
  const Rational low = Rational(-kHeight) / 2, tilt = Rational(1) / 5;
  const Vector3 lower_left{-kHalfWidth, 0, low}, lower_right{kHalfWidth, 0, low};
  if (name == "A") return Make(name, kWide, Placed(tilt, lower_right, {-40, 0, 0}));
  if (name == "B") return Make(name, kWide, Placed(tilt, lower_right, {0, 0, 0}));
  if (name == "B slot") {
    // The peg leans to the right by the tilt: its lower left edge on the left wall, its right face on the right rim.
    // Across the slot: width = peg's width * cos + (length up to the rim) * sin; the depth follows.
    const Rational cosine = (1 - tilt * tilt) / (1 + tilt * tilt), sine = 2 * tilt / (1 + tilt * tilt);
    const Rational height =
        (kWide - 2 * kHalfWidth * cosine) / sine;                // along the peg, from its lower right edge
    const Rational z = 2 * kHalfWidth * sine - height * cosine;  // of the lower left edge
    return Make(name, kWide, Placed(tilt, lower_left, {0, 0, z}));
  }
  if (name == "C") return Make(name, kWide, Placed(0, lower_left, {0, 0, -kSlotDepth}));
  if (name == "C seated") return Make(name, kFitting, Placed(0, lower_left, {0, 0, -kSlotDepth}));
  throw PreconditionError("table relation: no " + name);
}

std::vector<std::string> TableRelationNames() { return {"A", "B", "B slot", "C", "C seated"}; }

TableRelation WithOriginAtContacts(TableRelation table) {
  Vector3 sum;
  for (const auto& contact : table.found.relation.contacts) sum = sum + contact.point;
  const Rational count = static_cast<int>(table.found.relation.contacts.size());
  const Vector3 origin = table.realisation.Inverse() * ((Rational(1) / count) * sum);
  table.moving = Transform(table.moving, Pose{{}, -origin});
  table.realisation = table.realisation * Pose{{}, origin};
  return table;
}

Relation RelationOf(const TableRelation& table) {
  return {recognition::PointContactsOf(table.found, Transform(table.moving, table.realisation), table.fixed),
          joint::ToTransform(table.realisation)};
}

}  // namespace tact::correction
