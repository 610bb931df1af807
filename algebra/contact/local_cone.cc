#include "algebra/contact/local_cone.h"

#include <algorithm>
#include <optional>
#include <set>

#include "algebra/cone/dual_simplex.h"
#include "algebra/error.h"
#include "algebra/solid/distance.h"

namespace tact::algebra {
namespace {

Rational SquaredLength(const Vector3& v) { return Dot(v, v); }

// The longest reach of a face's corners from the point along a direction, as a multiple of the direction.
Vector3 Reach(const Polyhedron& solid, const Face& face, const Vector3& point, const Vector3& direction) {
  Rational farthest(0);
  for (const size_t v : face.loops[0]) {
    const Rational along = Dot(solid.vertices[v].point - point, direction);
    if (along > farthest) farthest = along;
  }
  return (farthest / SquaredLength(direction)) * direction;
}

// The in-plane direction from an edge into the face that has the given outward normal; the face is on the
// left of the edge's own direction.
Vector3 IntoFace(const Vector3& normal, const Vector3& along) { return Cross(normal, along); }

ConvexPiece FacePiece(const Polyhedron& solid, const Face& face) {
  const Vector3 along = solid.vertices[face.loops[0][1]].point - solid.vertices[face.loops[0][0]].point;
  const Vector3 across = IntoFace(face.normal, along);
  const Vector3& origin = solid.vertices[face.loops[0][0]].point;
  const Vector3 u = Reach(solid, face, origin, along), v = Reach(solid, face, origin, across);
  return {{face.normal}, {u, -u, v, -v, -face.normal}};
}

std::vector<ConvexPiece> EdgePieces(const Polyhedron& solid, const Edge& edge) {
  const Face &left = solid.faces[edge.left], &right = solid.faces[edge.right];
  if (edge.convexity == Convexity::kConcave) return {FacePiece(solid, left), FacePiece(solid, right)};
  const Vector3& tail = solid.vertices[edge.tail].point;
  const Vector3 along = solid.vertices[edge.head].point - tail;
  return {{{left.normal, right.normal},
           {along, -along, Reach(solid, left, tail, IntoFace(left.normal, along)),
            Reach(solid, right, tail, IntoFace(right.normal, -along))}}};
}

std::vector<size_t> FacesAt(const Polyhedron& solid, const Element& element) {
  if (element.kind == ElementKind::kFace) return {element.index};
  if (element.kind == ElementKind::kVertex) return solid.vertices[element.index].faces;
  return {solid.edges[element.index].left, solid.edges[element.index].right};
}

// Distinct normals of the faces, in their order.
std::vector<Vector3> NormalsOf(const Polyhedron& solid, const std::vector<size_t>& faces) {
  std::vector<Vector3> normals;
  for (const size_t f : faces) {
    const Vector3& n = solid.faces[f].normal;
    if (std::find(normals.begin(), normals.end(), n) == normals.end()) normals.push_back(n);
  }
  return normals;
}

std::vector<Vector3> EdgeDirections(const Polyhedron& solid, const Vertex& vertex, size_t v) {
  std::vector<Vector3> directions;
  for (const size_t e : vertex.edges) {
    const Edge& edge = solid.edges[e];
    directions.push_back(solid.vertices[edge.tail == v ? edge.head : edge.tail].point - vertex.point);
  }
  return directions;
}

bool InPiece(const std::vector<Vector3>& normals, const Vector3& d) {
  return std::all_of(normals.begin(), normals.end(), [&](const Vector3& n) { return Dot(n, d).sign() <= 0; });
}

Rational LargestEntry(const Vector3& v) { return std::max({Abs(v.x), Abs(v.y), Abs(v.z)}); }

// The directions that generate { d | n . d <= 0 }, in no particular length: where two facets meet, and inside
// the facets if there are fewer than three.
std::vector<Vector3> GeneratingDirections(const std::vector<Vector3>& normals) {
  std::vector<Vector3> found;
  if (normals.empty()) return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  if (normals.size() == 1) {
    const Vector3 u = Cross(normals[0], normals[0].x.sign() != 0 ? Vector3{0, 1, 0} : Vector3{1, 0, 0});
    const Vector3 w = Cross(normals[0], u);
    return {u, -u, w, -w, -normals[0]};
  }
  for (size_t i = 0; i < normals.size(); ++i) {
    for (size_t j = i + 1; j < normals.size(); ++j) {
      const Vector3 line = Cross(normals[i], normals[j]);
      for (const Vector3& d : {line, -line}) {
        if (InPiece(normals, d)) found.push_back(d);
      }
      if (normals.size() > 2) continue;
      for (const Vector3& in_facet : {Cross(line, normals[i]), Cross(line, normals[j])}) {
        found.push_back(InPiece(normals, in_facet) ? in_facet : -in_facet);
      }
    }
  }
  return found;
}

// A piece at a vertex: its directions get the length of the solid's edge there if it has one, else that of
// the shortest edge around (in the largest coordinate, which is rational).
ConvexPiece VertexPiece(const std::vector<Vector3>& normals, const std::vector<Vector3>& edges) {
  ConvexPiece piece{normals, {}};
  Rational shortest = LargestEntry(edges[0]);
  for (const Vector3& e : edges) shortest = std::min(shortest, LargestEntry(e));
  for (const Vector3& d : GeneratingDirections(normals)) {
    const auto edge = std::find_if(edges.begin(), edges.end(),
                                   [&](const Vector3& e) { return Primitive(e) == Primitive(d); });
    piece.directions.push_back(edge != edges.end() ? *edge : (shortest / LargestEntry(d)) * d);
  }
  return piece;
}

// A direction strictly inside the cell with the given sides (+1: n . d > 0) of the planes, if there is one.
std::optional<Vector3> CellDirection(const std::vector<Vector3>& normals, const std::vector<int>& sides) {
  std::vector<Integer> rows;
  for (size_t i = 0; i < sides.size(); ++i) {
    for (int k = 0; k < 3; ++k)
      rows.push_back(sides[i] > 0 ? normals[i][k].numerator() : -normals[i][k].numerator());
  }
  DualSimplex<Integer> simplex;
  simplex.Solve(rows.data(), sides.size(), 3, 3);
  if (simplex.vanishing_rank() > 0) return std::nullopt;
  const auto x = simplex.interior_point();
  return Vector3{Rational(x[0]), Rational(x[1]), Rational(x[2])};
}

// Whether a step from the point in a direction off all planes through it enters the solid.
bool Enters(const Polyhedron& solid, const Vector3& point, const Vector3& d) {
  Rational nearest(1);
  for (const Face& face : solid.faces) {
    const Rational rate = Dot(face.normal, d), gap = face.offset - Dot(face.normal, point);
    if (rate.sign() == 0 || gap.sign() == 0) continue;
    const Rational t = gap / rate;
    if (t.sign() > 0 && t < nearest) nearest = t;
  }
  return Locate(solid, point + (nearest / Rational(2)) * d) == Side::kInside;
}

struct Cell {
  std::vector<int> sides;
  bool inside = false;
};

std::vector<Cell> Cells(const Polyhedron& solid, const Vector3& point, const std::vector<Vector3>& normals) {
  std::vector<std::vector<int>> partial = {{}};
  for (size_t i = 0; i < normals.size(); ++i) {
    std::vector<std::vector<int>> next;
    for (auto& sides : partial) {
      for (const int side : {-1, 1}) {
        sides.push_back(side);
        if (CellDirection(normals, sides)) next.push_back(sides);
        sides.pop_back();
      }
    }
    partial = std::move(next);
  }
  std::vector<Cell> cells;
  for (auto& sides : partial) {
    const Vector3 d = *CellDirection(normals, sides);
    cells.push_back({std::move(sides), Enters(solid, point, d)});
  }
  return cells;
}

// Grows every minimal set of planes that cuts off all outside cells.
void MinimalCuts(const std::vector<Cell>& cells, std::set<size_t>& chosen, std::set<std::set<size_t>>& cuts) {
  for (const Cell& cell : cells) {
    if (cell.inside) continue;
    if (std::any_of(chosen.begin(), chosen.end(), [&](size_t i) { return cell.sides[i] > 0; })) continue;
    for (size_t i = 0; i < cell.sides.size(); ++i) {
      if (cell.sides[i] < 0 || chosen.contains(i)) continue;
      chosen.insert(i);
      MinimalCuts(cells, chosen, cuts);
      chosen.erase(i);
    }
    return;
  }
  cuts.insert(chosen);
}

// The largest pieces between planes through a point that fit in the solid; edges as in VertexPiece.
std::vector<ConvexPiece> LargestPieces(const Polyhedron& solid, const Vector3& point,
                                       const std::vector<Vector3>& normals,
                                       const std::vector<Vector3>& edges) {
  const std::vector<Cell> cells = Cells(solid, point, normals);
  std::set<std::set<size_t>> cuts;
  std::set<size_t> chosen;
  MinimalCuts(cells, chosen, cuts);
  std::vector<ConvexPiece> pieces;
  std::vector<char> covered(cells.size(), 0);
  for (const auto& cut : cuts) {
    const bool minimal = std::none_of(cuts.begin(), cuts.end(), [&](const std::set<size_t>& other) {
      return other != cut && std::includes(cut.begin(), cut.end(), other.begin(), other.end());
    });
    if (!minimal) continue;
    std::vector<Vector3> kept;
    for (const size_t i : cut) kept.push_back(normals[i]);
    bool full = false;
    for (size_t c = 0; c < cells.size(); ++c) {
      const bool holds = std::all_of(cut.begin(), cut.end(), [&](size_t i) { return cells[c].sides[i] < 0; });
      if (holds) covered[c] = 1;
      full = full || holds;
    }
    if (full) pieces.push_back(VertexPiece(kept, edges));
  }
  for (size_t c = 0; c < cells.size(); ++c) {
    if (cells[c].inside && covered[c] == 0)
      throw InvariantError("a point is not covered by its convex pieces");
  }
  return pieces;
}

std::vector<ConvexPiece> VertexPieces(const Polyhedron& solid, size_t v) {
  const Vertex& vertex = solid.vertices[v];
  const std::vector<Vector3> normals = NormalsOf(solid, vertex.faces);
  const std::vector<Vector3> edges = EdgeDirections(solid, vertex, v);
  const auto is = [&](Convexity c) {
    return std::all_of(vertex.edges.begin(), vertex.edges.end(),
                       [&](size_t e) { return solid.edges[e].convexity == c; });
  };
  if (is(Convexity::kConvex) && normals.size() == vertex.faces.size()) return {VertexPiece(normals, edges)};
  if (is(Convexity::kConcave) && normals.size() == vertex.faces.size()) {
    std::vector<ConvexPiece> pieces;
    for (const Vector3& n : normals) pieces.push_back(VertexPiece({n}, edges));
    return pieces;
  }
  Polyhedron shell = solid;
  std::erase_if(shell.faces, [&](const Face& f) { return f.shell != vertex.shell; });
  return LargestPieces(shell, vertex.point, normals, edges);
}

// The face, or the edge or vertex of its boundary, that holds a point of the closed face.
Element PartOfFace(const Polyhedron& solid, size_t f, const Vector3& point) {
  const Face& face = solid.faces[f];
  for (size_t k = 0; k < face.loops.size(); ++k) {
    for (size_t i = 0; i < face.loops[k].size(); ++i) {
      const Vector3& a = solid.vertices[face.loops[k][i]].point;
      const Vector3& b = solid.vertices[face.loops[k][(i + 1) % face.loops[k].size()]].point;
      if (a == point) return {ElementKind::kVertex, face.loops[k][i]};
      if (Parallel(a - point, b - point) && Dot(a - point, b - point).sign() < 0) {
        return {ElementKind::kEdge, face.loop_edges[k][i]};
      }
    }
  }
  return {ElementKind::kFace, f};
}

}  // namespace

std::string ToString(const Element& element) {
  static const char* const kNames[] = {"vertex ", "edge ", "face "};
  return kNames[static_cast<int>(element.kind)] + std::to_string(element.index);
}

std::vector<ConvexPiece> LocalPieces(const Polyhedron& solid, const Element& element) {
  switch (element.kind) {
    case ElementKind::kVertex:
      return VertexPieces(solid, element.index);
    case ElementKind::kEdge:
      return EdgePieces(solid, solid.edges[element.index]);
    case ElementKind::kFace:
      return {FacePiece(solid, solid.faces[element.index])};
  }
  throw InvariantError("an element of no kind");
}

std::vector<Element> ElementsAt(const Polyhedron& solid, const Vector3& point) {
  std::set<Element> elements;
  for (size_t f = 0; f < solid.faces.size(); ++f) {
    const Face& face = solid.faces[f];
    if (Dot(face.normal, point) == face.offset && FaceContains(solid, face, point)) {
      elements.insert(PartOfFace(solid, f, point));
    }
  }
  return {elements.begin(), elements.end()};
}

std::vector<ConvexPiece> LocalPieces(const Polyhedron& solid, const Vector3& point) {
  const std::vector<Element> elements = ElementsAt(solid, point);
  if (elements.empty()) throw PreconditionError("the point " + ToString(point) + " is not on the surface");
  if (elements.size() == 1) return LocalPieces(solid, elements[0]);
  std::vector<size_t> faces;
  std::vector<Vector3> directions;
  for (const Element& element : elements) {
    for (const size_t f : FacesAt(solid, element)) faces.push_back(f);
    for (const ConvexPiece& piece : LocalPieces(solid, element)) {
      directions.insert(directions.end(), piece.directions.begin(), piece.directions.end());
    }
  }
  return LargestPieces(solid, point, NormalsOf(solid, faces), directions);
}

bool Bounds(const Polyhedron& solid, const Element& element, const ConvexPiece& piece) {
  const std::vector<Vector3> normals = NormalsOf(solid, FacesAt(solid, element));
  return std::any_of(normals.begin(), normals.end(), [&](const Vector3& n) {
    return std::find(piece.normals.begin(), piece.normals.end(), n) != piece.normals.end();
  });
}

}  // namespace tact::algebra
