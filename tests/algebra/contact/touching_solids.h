/// @file
/// Random exact solids that touch, and how two of them meet, decided without the solids' code.
/// Model   A body is a solid together with convex parts whose union it is. Two parts overlap if the cone
///         { (x, t) | o t - n . x >= 0 for all their faces, t >= 0 } has all four dimensions, and share a
///         point if it has some t > 0: its strictly complementary pair says both.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "algebra/cone/complementary_pair.h"
#include "algebra/contact/contact_finder.h"
#include "algebra/contact/motion_dof.h"
#include "algebra/exact/integer_matrix.h"
#include "tests/algebra/solid/solids.h"

namespace tact::algebra {

struct SampleBody {
  Polyhedron solid;
  std::vector<Polyhedron> parts;
};

inline SampleBody Convex(const PolygonSoup& soup) {
  const Polyhedron solid = BuildPolyhedron(soup);
  return {solid, {solid}};
}

inline SampleBody Transform(const SampleBody& body, const Pose& X) {
  SampleBody moved{Transform(body.solid, X), {}};
  for (const Polyhedron& part : body.parts) moved.parts.push_back(Transform(part, X));
  return moved;
}

enum class Meeting { kApart, kTouching, kOverlapping };

inline Meeting MeetingOf(const Polyhedron& a, const Polyhedron& b) {
  std::vector<std::vector<Rational>> rows = {{0, 0, 0, 1}};
  for (const Polyhedron* part : {&a, &b}) {
    for (const Face& f : part->faces) rows.push_back({-f.normal.x, -f.normal.y, -f.normal.z, f.offset});
  }
  const ComplementaryPair pair = FindComplementaryPair(IntegerMatrix::FromRationalRows(rows, 4).entries, 4);
  if (pair.y[0].sign() > 0) return Meeting::kApart;  // t = 0 throughout
  const bool full = std::all_of(pair.y.begin(), pair.y.end(), [](const Integer& y) { return y.sign() == 0; });
  return full ? Meeting::kOverlapping : Meeting::kTouching;
}

inline Meeting MeetingOf(const SampleBody& a, const SampleBody& b) {
  Meeting most = Meeting::kApart;
  for (const Polyhedron& p : a.parts) {
    for (const Polyhedron& q : b.parts) most = std::max(most, MeetingOf(p, q));
  }
  return most;
}

/// Fixed seeds, and the same numbers everywhere: no distribution of the library's is used.
class Dice {
 public:
  explicit Dice(unsigned seed) : engine_(seed) {}
  /// low <= result <= high.
  int Roll(int low, int high) { return low + static_cast<int>(engine_() % (high - low + 1)); }
  Vector3 RollVector(int low, int high) { return {Roll(low, high), Roll(low, high), Roll(low, high)}; }

 private:
  std::mt19937 engine_;
};

/// Unit cubes of a small grid as one solid, or with each cube a shell of its own, carried by a linear map of
/// positive determinant.
struct Cubes {
  std::vector<Vector3> cells;
  std::array<Vector3, 3> columns{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  bool Has(const Vector3& cell) const { return std::find(cells.begin(), cells.end(), cell) != cells.end(); }
  Vector3 Map(const Vector3& p) const { return p.x * columns[0] + p.y * columns[1] + p.z * columns[2]; }
  PolygonSoup Mapped(PolygonSoup soup) const {
    for (Vector3& p : soup.points) p = Map(p);
    return soup;
  }
  PolygonSoup OneShell() const {
    static const Vector3 kSides[] = {{0, 0, -1}, {0, 0, 1}, {0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
    PolygonSoup soup;
    for (const Vector3& cell : cells) {
      PolygonSoup cube = Box(cell, cell + Vector3{1, 1, 1});
      std::vector<std::vector<size_t>> open;
      for (size_t side = 0; side < 6; ++side) {
        if (!Has(cell + kSides[side])) open.push_back(cube.polygons[side]);
      }
      cube.polygons = std::move(open);
      soup = soup + cube;
    }
    return Mapped(std::move(soup));
  }
  PolygonSoup ManyShells() const {
    PolygonSoup soup;
    for (const Vector3& cell : cells) soup = soup + Box(cell, cell + Vector3{1, 1, 1});
    return Mapped(std::move(soup));
  }
  std::vector<Polyhedron> Parts() const {
    std::vector<Polyhedron> parts;
    for (const Vector3& cell : cells) {
      parts.push_back(BuildPolyhedron(Mapped(Box(cell, cell + Vector3{1, 1, 1}))));
    }
    return parts;
  }
};

inline Rational Determinant(const std::array<Vector3, 3>& columns) {
  return Dot(Cross(columns[0], columns[1]), columns[2]);
}

/// A random set of cubes whose union is one solid; convex and concave edges, vertices of every mixture.
inline Cubes RandomCubes(Dice& dice) {
  for (;;) {
    Cubes cubes;
    for (int i = 0; i < 8; ++i) {
      if (dice.Roll(0, 2) > 0) cubes.cells.push_back({i & 1, i >> 1 & 1, i >> 2});
    }
    if (dice.Roll(0, 2) == 0) {
      for (Vector3& column : cubes.columns) column = dice.RollVector(-2, 2);
      if (Determinant(cubes.columns).sign() <= 0) continue;
    } else {
      for (int i = 0; i < 3; ++i) cubes.columns[i] = Rational(dice.Roll(1, 3)) * cubes.columns[i];
    }
    if (!cubes.cells.empty() && Refusal(cubes.OneShell()).empty()) return cubes;
  }
}

inline SampleBody RandomTetrahedron(Dice& dice) {
  for (;;) {
    PolygonSoup soup;
    for (int i = 0; i < 4; ++i) soup.points.push_back(dice.RollVector(-2, 2));
    soup.polygons = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    const Vector3& o = soup.points[0];
    const int sign = Determinant({soup.points[1] - o, soup.points[2] - o, soup.points[3] - o}).sign();
    if (sign != 0) return Convex(sign > 0 ? soup : Reversed(soup));
  }
}

inline SampleBody RandomBody(Dice& dice) {
  switch (dice.Roll(0, 4)) {
    case 0:
      return Convex(Box({0, 0, 0}, dice.RollVector(1, 3)));
    case 1:
      return Convex(Prism({{0, 0}, {dice.Roll(1, 3), 0}, {dice.Roll(-1, 2), dice.Roll(1, 3)}}, 0, 2));
    case 2:
      return RandomTetrahedron(dice);
    default: {
      const Cubes cubes = RandomCubes(dice);
      return {BuildPolyhedron(cubes.OneShell()), cubes.Parts()};
    }
  }
}

/// Of the group of the cube, turned about z, or any.
inline Rotation RandomRotation(Dice& dice) {
  const auto turned = [&] {
    Rotation r;
    for (int i = dice.Roll(0, 3); i > 0; --i) r = Rotation::FromQuaternion(1, 0, 0, 1) * r;
    for (int i = dice.Roll(0, 3); i > 0; --i) r = Rotation::FromQuaternion(1, 1, 0, 0) * r;
    for (int i = dice.Roll(0, 3); i > 0; --i) r = Rotation::FromQuaternion(1, 0, 1, 0) * r;
    return r;
  };
  const int kind = dice.Roll(0, 3);
  if (kind == 0) return turned();
  if (kind == 1) return Rotation::FromQuaternion(dice.Roll(1, 4), 0, 0, dice.Roll(1, 4)) * turned();
  const Vector3 axis = dice.RollVector(-3, 3);
  return Rotation::FromQuaternion(dice.Roll(1, 4), axis.x, axis.y, axis.z);
}

/// A vertex, or a point of an edge, or one between three corners of a face (inside it if it is convex).
inline Vector3 RandomSurfacePoint(Dice& dice, const Polyhedron& solid) {
  const auto pick = [&](size_t count) {
    return static_cast<size_t>(dice.Roll(0, static_cast<int>(count) - 1));
  };
  const auto between = [&](size_t a, size_t b) {
    const Rational t(dice.Roll(1, 3), 4);
    return (1 - t) * solid.vertices[a].point + t * solid.vertices[b].point;
  };
  switch (dice.Roll(0, 3)) {
    case 0:
    case 1:
      return solid.vertices[pick(solid.vertices.size())].point;
    case 2: {
      const Edge& edge = solid.edges[pick(solid.edges.size())];
      return between(edge.tail, edge.head);
    }
    default: {
      const auto& loop = solid.faces[pick(solid.faces.size())].loops[0];
      const size_t i = pick(loop.size());
      return Rational(1, 2) * between(loop[i], loop[(i + 1) % loop.size()]) +
             Rational(1, 2) * solid.vertices[loop[(i + 2) % loop.size()]].point;
    }
  }
}

/// Turns and shifts the body so that a point of its surface comes to one of the other's; of a few tries the
/// first that does not overlap, if there is one.
inline SampleBody RandomlyPlaced(Dice& dice, const SampleBody& body, const SampleBody& other) {
  SampleBody placed;
  for (int tries = 0; tries < 4; ++tries) {
    const SampleBody turned = Transform(body, Pose{RandomRotation(dice), {}});
    const Vector3 from = RandomSurfacePoint(dice, turned.solid), to = RandomSurfacePoint(dice, other.solid);
    placed = Transform(turned, Pose{{}, to - from});
    if (MeetingOf(placed, other) != Meeting::kOverlapping) break;
  }
  return placed;
}

/// Maintaining, detaching, constraining in translation / in rotation / restricted in both.
inline std::string BriefOf(const ContactRelation& relation) {
  const MotionDof dof = ComputeMotionDof(relation);
  const auto digits = [](int a, int b, int c) {
    return std::to_string(a) + std::to_string(b) + std::to_string(c);
  };
  return std::string(dof.singular ? "singular " : "") +
         digits(dof.translation.maintaining, dof.translation.detaching, dof.translation.constraining) + "/" +
         digits(dof.rotation.maintaining, dof.rotation.detaching, dof.rotation.constraining) + "/" +
         std::to_string(dof.translation.restricted) + std::to_string(dof.rotation.restricted);
}

}  // namespace tact::algebra
