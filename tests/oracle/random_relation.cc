#include "tests/oracle/random_relation.h"

#include <array>

namespace tact::oracle {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Integer;
using algebra::Rational;
using algebra::Vector3;

constexpr int kMostContacts = 12;
constexpr int kPointRules = 6;
constexpr int kNormalRules = 7;

Rational SmallRational(Random& random) {
  const int denominator = random.OneIn(3) ? random.Int(2, 4) : 1;
  return Rational(Integer(random.Int(-4, 4)), Integer(denominator));
}

Vector3 SmallVector(Random& random) {
  return {SmallRational(random), SmallRational(random), SmallRational(random)};
}

Vector3 SmallDirection(Random& random) {
  for (;;) {
    const Vector3 v{random.Int(-2, 2), random.Int(-2, 2), random.Int(-2, 2)};
    if (!v.IsZero()) return v;
  }
}

Vector3 Axis(Random& random) {
  Vector3 v;
  v[random.Int(0, 2)] = random.OneIn(2) ? 1 : -1;
  return v;
}

// What the contacts of one relation share.
struct Pool {
  explicit Pool(Random& random)
      : centre(SmallVector(random)), line(SmallDirection(random)), other(SmallDirection(random)) {
    for (Vector3& p : points) p = SmallVector(random);
    for (Vector3& n : normals) n = SmallDirection(random);
  }
  std::array<Vector3, 2> points;
  std::array<Vector3, 2> normals;
  Vector3 centre, line, other;
};

Vector3 DrawNormal(Random& random, const Pool& pool, int rule) {
  switch (rule) {
    case 0:
      return SmallDirection(random);
    case 1:
      return pool.normals[random.Int(0, 1)];
    case 2:
      return random.OneIn(2) ? pool.normals[0] : -pool.normals[0];
    case 3:
      return Axis(random);
    case 4:  // in the plane of two directions
      for (;;) {
        const Vector3 n = Rational(random.Int(-2, 2)) * pool.line + Rational(random.Int(-2, 2)) * pool.other;
        if (!n.IsZero() || algebra::Parallel(pool.line, pool.other)) return n.IsZero() ? pool.line : n;
      }
    case 5:
      return random.OneIn(2) ? pool.line : -pool.line;
    default: {  // across a common line
      const Vector3 n = Cross(pool.line, SmallDirection(random));
      return n.IsZero() ? pool.other : n;
    }
  }
}

Vector3 DrawPoint(Random& random, const Pool& pool, int rule, const Vector3& normal) {
  switch (rule) {
    case 0:
      return SmallVector(random);
    case 1:
      return pool.points[random.Int(0, 1)];
    case 2:
      return pool.centre + SmallRational(random) * pool.line;
    case 3:
      return pool.centre + SmallRational(random) * pool.line + SmallRational(random) * pool.other;
    case 4:  // the line of action meets the centre
      return pool.centre + SmallRational(random) * normal;
    default: {  // on the face of a box whose outward direction is nearest to the normal
      Vector3 p{random.Int(-1, 1), random.Int(-1, 1), random.Int(-1, 1)};
      for (int i = 0; i < 3; ++i) {
        if (normal[i].sign() != 0) return p[i] = normal[i].sign(), p;
      }
      return p;
    }
  }
}

}  // namespace

uint64_t Random::Next() {  // splitmix64
  uint64_t z = state_ += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

ContactRelation RandomRelation(uint64_t seed, uint64_t index) {
  Random random(seed, index);
  const Pool pool(random);
  const bool singular = random.OneIn(10);
  const bool mixed = random.OneIn(4);
  int point_rule = random.Int(0, kPointRules - 1);
  int normal_rule = random.Int(0, kNormalRules - 1);
  ContactRelation relation;
  const int contacts = random.Int(0, kMostContacts);
  for (int i = 0; i < contacts; ++i) {
    if (mixed) {
      point_rule = random.Int(0, kPointRules - 1);
      normal_rule = random.Int(0, kNormalRules - 1);
    }
    Contact contact;
    // Without the singular contacts something should be left to look at: two in three stay as they are.
    const int planes = singular && (i == 0 || random.OneIn(3)) ? random.Int(2, 3) : 1;
    for (int j = 0; j < planes; ++j) contact.planes.push_back(DrawNormal(random, pool, normal_rule));
    contact.point = DrawPoint(random, pool, point_rule, contact.planes.front());
    if (random.OneIn(4))
      contact.planes.front() = Rational(Integer(random.Int(1, 5)), Integer(3)) * contact.planes.front();
    relation.contacts.push_back(contact);
  }
  return relation;
}

}  // namespace tact::oracle
