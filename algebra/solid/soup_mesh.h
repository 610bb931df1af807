/// @file
/// Half-edges of a polygon soup: the closed, oriented surfaces its polygons form, before faces are merged.
/// Model   half-edge h runs from tail to head with its polygon on the left seen from outside; twin runs back.
/// Exact   rational coordinates; no tolerance anywhere.
#pragma once

#include <string>
#include <vector>

#include "algebra/solid/planar_region.h"
#include "algebra/solid/polyhedron.h"

namespace tact::algebra {

struct HalfEdge {
  size_t tail = 0, head = 0;
  size_t next = 0, previous = 0, twin = 0;
  size_t polygon = 0;
};

struct SoupMesh {
  std::vector<Vector3> points;       // distinct, in order of first appearance
  std::vector<HalfEdge> half_edges;  // those of polygon i from first[i] to first[i + 1]
  std::vector<size_t> first;
  std::vector<Vector3> normals;  // of each polygon, outward, primitive
  std::vector<Rational> offsets;
  std::vector<size_t> shell;  // of each polygon, numbered by first polygon
  size_t shells = 0;

  PlanarRegion Region(size_t polygon) const;
};

/// Throws SoupError for each defect that a polygon, an edge or two neighbours show.
SoupMesh BuildSoupMesh(const PolygonSoup& soup);

/// Throws SoupError unless every shell is free of self-intersections. A shell may touch itself at corners.
void RefuseSelfIntersections(const SoupMesh& mesh);

/// Coplanar neighbours become one face; also the first polygon of each face.
struct MergedFaces {
  Polyhedron solid;
  std::vector<size_t> first_polygon;
};
MergedFaces MergeFaces(const SoupMesh& mesh);

/// Throws SoupError unless every point off the surface is in one shell's solid at most, and every shell of
/// negative volume is a cavity that touches nothing outside it.
void RefuseBadShells(const MergedFaces& merged);

/// How often the shells wound around a point that is on none of them; 1 inside, 0 outside. Shells for which
/// counts is false are passed over.
int Winding(const Polyhedron& solid, const Vector3& point, const std::vector<bool>& counts);

/// A decimal if the number is one, else p/q, or roughly if that is long.
std::string DecimalText(const Rational& value);
std::string ApproximateText(double value);
std::string PointText(const Vector3& point);
/// Polygons are counted from 1 in texts.
std::string PolygonText(size_t polygon);
[[noreturn]] void Refuse(std::string what, size_t polygon);

}  // namespace tact::algebra
