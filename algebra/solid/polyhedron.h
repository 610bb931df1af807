/// @file
/// Exact polyhedra: closed, oriented, with planar faces that may have holes, concave features known as such.
/// Model   A polyhedron is the union of its shells' solids. Shells may touch one another (a peg set on a
///         cube as a body of its own) but may not interpenetrate. A cavity is a shell of negative volume
///         inside another.
/// Units   the coordinates' length unit, named by whoever read them.
/// Exact   rational coordinates; no tolerance anywhere.
#pragma once

#include <cstddef>
#include <exception>
#include <string>
#include <vector>

#include "algebra/screw/pose.h"

namespace tact::algebra {

enum class Convexity { kConvex, kConcave };

/// A corner of one shell. Edges and faces are listed counter-clockwise seen from outside:
/// faces[i] lies between edges[i] and edges[i + 1].
struct Vertex {
  Vector3 point;
  std::vector<size_t> edges;
  std::vector<size_t> faces;
  size_t shell = 0;
};

/// A straight edge between two faces of different planes. left is the face on the left when walking from
/// tail to head seen from outside; that face's boundary runs tail to head.
struct Edge {
  size_t tail = 0, head = 0;
  size_t left = 0, right = 0;
  Convexity convexity = Convexity::kConvex;
};

/// A planar face; loops[0] is the outer boundary, counter-clockwise seen from outside, the others are holes,
/// clockwise. Each loop lists vertices; loop_edges the edges between vertex i and i + 1.
struct Face {
  Vector3 normal;   // outward, primitive integers
  Rational offset;  // normal . p on the plane
  std::vector<std::vector<size_t>> loops;
  std::vector<std::vector<size_t>> loop_edges;
  size_t shell = 0;
};

struct Polyhedron {
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  size_t shells = 0;
};

/// What a file of polygons says: corner points and, for each polygon, indices into them.
struct PolygonSoup {
  std::vector<Vector3> points;
  std::vector<std::vector<size_t>> polygons;
};

/// A defect of a soup that keeps it from bounding a solid; polygon is its index in the soup (npos: none).
struct SoupDefect {
  static constexpr size_t kNone = static_cast<size_t>(-1);
  std::string what;  // a sentence that names vertices by their coordinates and says what to do
  size_t polygon = kNone;
};

/// The polyhedron a soup bounds: equal points are one, coplanar neighbours are merged into faces (with
/// holes where they enclose one), straight-through vertices disappear. Vertices keep the order of their first
/// appearance in soup.points, faces that of their first polygon. Throws SoupError.
/// Refused: fewer than 3 corners, repeated corners, zero area, non-planar polygons, edges with one polygon
/// (open), with more than two (non-manifold) or run twice in one direction (a flipped polygon), inverted
/// shells, self-intersections.
class SoupError : public std::exception {
 public:
  explicit SoupError(SoupDefect defect) : defect_(std::move(defect)) {}
  const SoupDefect& defect() const noexcept { return defect_; }
  const char* what() const noexcept override { return defect_.what.c_str(); }

 private:
  SoupDefect defect_;
};

Polyhedron BuildPolyhedron(const PolygonSoup& soup);

/// Where a point lies.
enum class Side { kInside, kOnBoundary, kOutside };
/// Of the union of the shells' solids. Exact ray parity; cost O(size).
Side Locate(const Polyhedron& solid, const Vector3& point);

/// The polyhedron carried by a pose.
Polyhedron Transform(const Polyhedron& solid, const Pose& X);

/// Six times the signed volume.
Rational SixfoldVolume(const Polyhedron& solid);

}  // namespace tact::algebra
