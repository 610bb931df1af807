#include "robot/recognition/exact_pose.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "algebra/exact/linear_algebra.h"

namespace tact::recognition {
namespace {

using algebra::Integer;
using algebra::Polyhedron;
using algebra::Pose;
using algebra::Rational;
using algebra::Rotation;
using algebra::Vector3;

constexpr double kTurnSteps = 4096;      // a free turn is rounded to a quaternion of integers up to this
constexpr double kLocationSteps = 1024;  // a free location to this part of the unit

// Of a free pose, the rationals are those that keep numbers short; they need not be nearest.
Rational Rounded(double value, double steps) {
  return {Integer(static_cast<long long>(std::llround(value * steps))),
          Integer(static_cast<long long>(steps))};
}

Eigen::Vector3d Double(const Vector3& v) { return {ToDouble(v.x), ToDouble(v.y), ToDouble(v.z)}; }
Vector3 Rounded(const Eigen::Vector3d& v, double steps) {
  return {Rounded(v.x(), steps), Rounded(v.y(), steps), Rounded(v.z(), steps)};
}

Eigen::Matrix3d Double(const Rotation& R) {
  Eigen::Matrix3d answer;
  for (int i = 0; i < 3; ++i) answer.row(i) = Double(R.rows[static_cast<size_t>(i)]).transpose();
  return answer;
}

Vector3 Along(const Polyhedron& solid, size_t edge) {
  return solid.vertices[solid.edges[edge].head].point - solid.vertices[solid.edges[edge].tail].point;
}

// The faces and edges on which a point contact lies.
struct Sides {
  std::set<size_t> faces, edges;
};

Sides OfVertex(const Polyhedron& solid, size_t vertex) {
  const algebra::Vertex& v = solid.vertices[vertex];
  return {{v.faces.begin(), v.faces.end()}, {v.edges.begin(), v.edges.end()}};
}
Sides OfEdge(const Polyhedron& solid, size_t edge) {
  return {{solid.edges[edge].left, solid.edges[edge].right}, {edge}};
}
Sides MovingSides(const Polyhedron& moving, const PointContact& contact) {
  if (contact.kind == PointContactKind::kVertexFace) return OfVertex(moving, contact.moving);
  if (contact.kind == PointContactKind::kEdgeEdge) return OfEdge(moving, contact.moving);
  return {{contact.moving}, {}};
}
Sides FixedSides(const Polyhedron& fixed, const PointContact& contact) {
  if (contact.kind == PointContactKind::kFaceVertex) return OfVertex(fixed, contact.fixed);
  if (contact.kind == PointContactKind::kEdgeEdge) return OfEdge(fixed, contact.fixed);
  return {{contact.fixed}, {}};
}

// moving, carried by the rotation, is along fixed, or at right angles to it.
struct Pair {
  Vector3 moving, fixed;
  friend auto operator<=>(const Pair&, const Pair&) = default;
};

struct Parallels {
  std::set<Pair> along, across;
};

// Sides are taken for parallel as kAligned says; of each direction the primitive multiple.
Parallels FindParallels(const Polyhedron& moving, const Polyhedron& fixed,
                        const std::vector<PointContact>& contacts, const Eigen::Matrix3d& R) {
  Parallels found;
  const auto consider = [&](const Vector3& m, const Vector3& f, bool alike) {
    const Eigen::Vector3d a = (R * Double(m)).normalized(), b = Double(f).normalized();
    if (alike && a.cross(b).norm() < kAligned)
      found.along.insert({Primitive(m), Primitive(a.dot(b) > 0 ? f : -f)});
    if (!alike && std::abs(a.dot(b)) < kAligned) found.across.insert({Primitive(m), Primitive(f)});
  };
  for (const PointContact& contact : contacts) {
    const Sides m = MovingSides(moving, contact), f = FixedSides(fixed, contact);
    for (const size_t i : m.faces) {
      for (const size_t j : f.faces) consider(moving.faces[i].normal, fixed.faces[j].normal, true);
      for (const size_t j : f.edges) consider(moving.faces[i].normal, Along(fixed, j), false);
    }
    for (const size_t i : m.edges) {
      for (const size_t j : f.faces) consider(Along(moving, i), fixed.faces[j].normal, false);
      for (const size_t j : f.edges) consider(Along(moving, i), Along(fixed, j), true);
    }
  }
  return found;
}

// The square root, if it is rational (and numerator and denominator are squares of doubles' integers).
std::optional<Rational> Root(const Rational& square) {
  if (square.sign() < 0) return std::nullopt;
  const auto root = [](const Integer& n) -> std::optional<Integer> {
    const Integer r(static_cast<long long>(std::llround(std::sqrt(ToDouble(Rational(n))))));
    return r * r == n ? std::optional(r) : std::nullopt;
  };
  const auto p = root(square.numerator()), q = root(square.denominator());
  return p && q ? std::optional(Rational(*p, *q)) : std::nullopt;
}

// The turn about an axis, axis times its half tangent over w.
Rotation Turn(const Rational& w, const Rational& s, const Vector3& axis) {
  return Rotation::FromQuaternion(w, s * axis.x, s * axis.y, s * axis.z);
}

// Near the angle, in radian, about an axis.
Rotation RoundedTurn(double angle, const Vector3& axis) {
  const double length = Double(axis).norm();
  return Turn(Rounded(std::cos(angle / 2), kTurnSteps), Rounded(std::sin(angle / 2) / length, kTurnSteps),
              axis);
}

// The angle of a rotation about an axis.
double AngleAbout(const Eigen::Matrix3d& R, const Vector3& axis) {
  return joint::RotationLog(R).dot(Double(axis).normalized());
}

// A rotation that takes the direction `from` to the direction `to`; none if their lengths have no rational ratio.
std::optional<Rotation> Carry(const Vector3& from, const Vector3& to) {
  const auto ratio = Root(Dot(to, to) / Dot(from, from));
  if (!ratio) return std::nullopt;
  const Vector3 m = *ratio * from;
  const Vector3 axis = Cross(m, to);
  if (!axis.IsZero()) return Turn(Dot(to, to) + Dot(m, to), 1, axis);
  if (m == to) return Rotation{};
  const Vector3 aside = Cross(to, to.x.sign() == 0 && to.y.sign() == 0 ? Vector3{1, 0, 0} : Vector3{0, 0, 1});
  return Turn(0, 1, aside);
}

// Turns about `along` after R0 that bring a across c: x : y with a half tangent of y |along| / x. Empty: all of them
// or none do; a rational one nearest to the angle, if there is any.
struct TurnAcross {
  bool any = false;
  std::optional<Rotation> turn;
};
TurnAcross FindTurnAcross(const Vector3& along, const Vector3& a, const Vector3& c, double angle) {
  const Rational square = Dot(along, along), part = Dot(a, along) / square;
  const Vector3 parallel = part * along, rest = a - parallel;
  const Rational A = Dot(c, a), B = 2 * Dot(c, Cross(along, rest)),
                 C = square * (Dot(c, parallel) - Dot(c, rest));
  if (A.sign() == 0 && B.sign() == 0 && C.sign() == 0) return {true, std::nullopt};
  std::vector<std::array<Rational, 2>> roots;
  if (A.sign() == 0) {
    roots = {{Rational(1), Rational(0)}, {-C, B}};
  } else if (const auto root = Root(B * B - 4 * A * C)) {
    roots = {{-B + *root, 2 * A}, {-B - *root, 2 * A}};
  }
  TurnAcross answer;
  double nearest = 1e-3;  // radian: of a turn that doubles find across to kAligned
  for (const auto& [x, y] : roots) {
    if (x.sign() == 0 && y.sign() == 0) continue;
    const double off = std::remainder(
        2 * std::atan2(ToDouble(y) * std::sqrt(ToDouble(square)), ToDouble(x)) - angle, 2 * M_PI);
    if (std::abs(off) > nearest) continue;
    nearest = std::abs(off);
    answer.turn = Turn(x, y, along);
  }
  return answer;
}

std::optional<Rotation> FromTwo(const Pair& first, const Pair& second) {
  std::array<Vector3, 3> h, g;
  h[0] = first.moving, g[0] = first.fixed;
  h[2] = Cross(first.moving, second.moving), g[2] = Cross(first.fixed, second.fixed);
  h[1] = Cross(h[2], h[0]), g[1] = Cross(g[2], g[0]);
  Rotation R;
  R.rows = {};
  for (size_t k = 0; k < 3; ++k) {
    const auto lengths = Root(Dot(h[k], h[k]) * Dot(g[k], g[k]));
    if (!lengths) return std::nullopt;
    for (int i = 0; i < 3; ++i)
      R.rows[static_cast<size_t>(i)] = R.rows[static_cast<size_t>(i)] + (g[k][i] / *lengths) * h[k];
  }
  return IsRotation(R) ? std::optional(R) : std::nullopt;
}

std::optional<Rotation> FromOne(const Pair& along, const std::set<Pair>& across, const Eigen::Matrix3d& R) {
  const auto R0 = Carry(along.moving, along.fixed);
  if (!R0) return std::nullopt;
  const double angle = AngleAbout(R * Double(*R0).transpose(), along.fixed);
  for (const Pair& pair : across) {
    const TurnAcross found = FindTurnAcross(along.fixed, *R0 * pair.moving, pair.fixed, angle);
    if (found.any) continue;
    return found.turn ? std::optional(*found.turn * *R0) : std::nullopt;
  }
  return RoundedTurn(angle, along.fixed) * *R0;
}

std::optional<Rotation> FromAcross(const Pair& across, const Eigen::Matrix3d& R) {
  const Vector3& c = across.fixed;
  std::vector<Vector3> square;  // some directions across c
  for (const Vector3& axis : {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    if (Dot(axis, c).sign() == 0) square.push_back(axis);
    if (!Parallel(axis, c)) square.push_back(Primitive(Cross(axis, c)));
  }
  square.push_back(across.moving);
  for (const Vector3& to : square) {
    if (Dot(to, c).sign() != 0) continue;
    const auto R0 = Carry(across.moving, to);
    if (!R0) continue;
    const Eigen::Vector3d b = Double(to).normalized(), a = (R * Double(across.moving)).normalized();
    const double angle = std::atan2(Double(c).normalized().dot(b.cross(a)), a.dot(b));
    const Rotation swing = RoundedTurn(angle, c);
    const double spin = AngleAbout(Double(*R0).transpose() * Double(swing).transpose() * R, across.moving);
    return swing * *R0 * RoundedTurn(spin, across.moving);
  }
  return std::nullopt;
}

std::optional<Rotation> FindRotation(const Parallels& parallels, const Eigen::Matrix3d& R) {
  const auto& [along, across] = parallels;
  if (!along.empty()) {
    const Pair& first = *along.begin();
    for (const Pair& second : along)
      if (!Parallel(second.moving, first.moving)) return FromTwo(first, second);
    return FromOne(first, across, R);
  }
  if (!across.empty()) return FromAcross(*across.begin(), R);
  const Eigen::Quaterniond q(R);
  return Rotation::FromQuaternion(Rounded(q.w(), kTurnSteps), Rounded(q.x(), kTurnSteps),
                                  Rounded(q.y(), kTurnSteps), Rounded(q.z(), kTurnSteps));
}

// The location with no gap that is nearest to `near`; none if no location has.
std::optional<Vector3> FindLocation(const Polyhedron& moving, const Polyhedron& fixed,
                                    const std::vector<PointContact>& contacts, const Rotation& R,
                                    const Vector3& near) {
  std::vector<Vector3> normals;   // primitive
  std::vector<Rational> missing;  // normal . (location - near)
  for (const PointContact& contact : contacts) {
    Vector3 n, from, to;  // the location is such that n . (R from + location - to) = 0
    if (contact.kind == PointContactKind::kVertexFace) {
      const algebra::Face& face = fixed.faces[contact.fixed];
      n = face.normal, from = moving.vertices[contact.moving].point;
      to = fixed.vertices[face.loops[0][0]].point;
    } else if (contact.kind == PointContactKind::kFaceVertex) {
      const algebra::Face& face = moving.faces[contact.moving];
      n = Primitive(R * face.normal), from = moving.vertices[face.loops[0][0]].point;
      to = fixed.vertices[contact.fixed].point;
    } else {
      n = Primitive(Cross(R * Along(moving, contact.moving), Along(fixed, contact.fixed)));
      from = moving.vertices[moving.edges[contact.moving].tail].point;
      to = fixed.vertices[fixed.edges[contact.fixed].tail].point;
    }
    normals.push_back(n);
    missing.push_back(Dot(n, to - R * from - near));
  }
  if (normals.empty()) return near;
  algebra::IntegerMatrix products(0, normals.size());
  for (const Vector3& a : normals) {
    algebra::IntegerVector row;
    for (const Vector3& b : normals) row.push_back(Dot(a, b).numerator());
    products.AppendRow(row);
  }
  const auto solution = Solve(products, missing);
  if (!solution.x) return std::nullopt;
  Vector3 location = near;
  for (size_t i = 0; i < normals.size(); ++i) location = location + (*solution.x)[i] * normals[i];
  return location;
}

}  // namespace

ExactPose FindExactPose(const Polyhedron& moving, const Polyhedron& fixed,
                        const std::vector<PointContact>& contacts, const joint::Transform& X_FM) {
  ExactPose answer;
  const auto R = FindRotation(FindParallels(moving, fixed, contacts, X_FM.R), X_FM.R);
  if (!R) {
    answer.why = "the contacts ask for a rotation that has no rational matrix";
    return answer;
  }
  const auto location = FindLocation(moving, fixed, contacts, *R, Rounded(X_FM.p, kLocationSteps));
  if (!location) {
    answer.why = "the contacts fix an angle that the exact pose nearby does not have";
    return answer;
  }
  const Pose X{*R, *location};
  const Polyhedron moved = Transform(moving, X);
  answer.found = FindContacts(moved, fixed, 0);
  if (answer.found.penetration) {
    answer.why = "the exact pose nearby penetrates by " +
                 std::to_string(std::sqrt(ToDouble(answer.found.penetration->squared_depth)));
    return answer;
  }
  answer.contacts = PointContactsOf(answer.found, moved, fixed);
  answer.X_FM = X;
  return answer;
}

}  // namespace tact::recognition
