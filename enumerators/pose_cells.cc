#include "enumerators/pose_cells.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"

namespace tact::enumerators {
namespace {

constexpr int kLargest = 1000;  // of a normal's entries: sums of products stay in an int

int ToInt(const algebra::Rational& value) {
  if (!value.is_integer() || !value.numerator().is_small() || std::abs(value.numerator().small()) > kLargest)
    throw PreconditionError("expected small integers, got " + value.ToString());
  return static_cast<int>(value.numerator().small());
}

Lattice3 PlaneOf(const algebra::Vector3& normal) {
  const algebra::Vector3 n = algebra::Primitive(normal);
  Lattice3 plane = {ToInt(n.x), ToInt(n.y), ToInt(n.z)};
  const int first = plane[0] != 0 ? plane[0] : (plane[1] != 0 ? plane[1] : plane[2]);
  if (first < 0) {
    for (int& v : plane) v = -v;
  }
  return plane;
}

std::set<algebra::Vector3> Directions(const algebra::Polyhedron& solid) {
  std::set<algebra::Vector3> directions;
  for (const algebra::Edge& e : solid.edges)
    directions.insert(algebra::Primitive(solid.vertices[e.head].point - solid.vertices[e.tail].point));
  return directions;
}

int Dot(const Lattice3& a, const Lattice3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Lattice3 Cross(const Lattice3& a, const Lattice3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

int FloorDivide(int a, int b) { return a / b - (a % b < 0 ? 1 : 0); }

}  // namespace

std::vector<Lattice3> EventNormals(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed) {
  std::set<Lattice3> normals;
  for (const auto* solid : {&moving, &fixed}) {
    for (const algebra::Face& f : solid->faces) normals.insert(PlaneOf(f.normal));
  }
  for (const algebra::Vector3& e : Directions(moving)) {
    for (const algebra::Vector3& g : Directions(fixed)) {
      const algebra::Vector3 n = algebra::Cross(e, g);
      if (!n.IsZero()) normals.insert(PlaneOf(n));
    }
  }
  return {normals.rbegin(), normals.rend()};
}

PoseCells::PoseCells(std::vector<Lattice3> normals) : normals_(std::move(normals)) {
  for (const Lattice3& axis : {Lattice3{1, 0, 0}, Lattice3{0, 1, 0}, Lattice3{0, 0, 1}}) {
    if (std::find(normals_.begin(), normals_.end(), axis) == normals_.end())
      throw PreconditionError("expected the coordinate axes among the normals");
  }
  FindCells();
  FindClosures();
}

PoseCells::Cell PoseCells::CellAt(const Lattice3& point) const {
  Cell cell{point, 0, {}};
  algebra::IntegerMatrix planes(0, 3);
  for (const Lattice3& n : normals_) {
    const int value = Dot(n, point), floor = FloorDivide(value, denominator_);
    const bool on_plane = floor * denominator_ == value;
    cell.floors.push_back(2 * floor + (on_plane ? 0 : 1));
    if (on_plane) planes.AppendRow(std::vector<algebra::Integer>{n[0], n[1], n[2]});
  }
  cell.dimension = 3 - static_cast<int>(algebra::Rank(planes));
  return cell;
}

void PoseCells::FindCells() {
  for (const Lattice3& a : normals_) {
    for (const Lattice3& b : normals_) {
      for (const Lattice3& c : normals_) {
        const int determinant = Dot(a, Cross(b, c));
        if (determinant != 0) denominator_ = std::lcm(denominator_, std::abs(determinant));
      }
    }
  }
  denominator_ *= 12;  // of the centre of two, three or four corners
  std::set<std::vector<int>> seen;
  std::vector<int> floors(normals_.size());
  for (int parts = 1; parts <= denominator_; ++parts) {
    if (denominator_ % parts != 0) continue;
    const int step = denominator_ / parts;
    for (int x = 0; x < denominator_; x += step) {
      for (int y = 0; y < denominator_; y += step) {
        for (int z = 0; z < denominator_; z += step) {
          const Lattice3 point = {x, y, z};
          for (size_t i = 0; i < normals_.size(); ++i) {
            const int value = Dot(normals_[i], point), floor = FloorDivide(value, denominator_);
            floors[i] = 2 * floor + (floor * denominator_ == value ? 0 : 1);
          }
          if (seen.insert(floors).second) cells_.push_back(CellAt(point));
        }
      }
    }
  }
}

void PoseCells::FindClosures() {
  closures_.resize(cells_.size());
  for (size_t g = 0; g < cells_.size(); ++g) {
    for (size_t f = 0; f < cells_.size(); ++f) {
      if (cells_[f].dimension >= cells_[g].dimension) continue;
      // The axes are among the normals: a cell's closure stays in [0, 1]^3.
      for (int corner = 0; corner < 8; ++corner) {
        const Lattice3 offset = {corner & 1, (corner >> 1) & 1, corner >> 2};
        bool in_closure = true;
        for (size_t i = 0; i < normals_.size() && in_closure; ++i) {
          const int of_g = cells_[g].floors[i], of_f = cells_[f].floors[i] + 2 * Dot(normals_[i], offset);
          in_closure = of_f == of_g || (of_g % 2 != 0 && std::abs(of_f - of_g) == 1);
        }
        if (in_closure) closures_[g].push_back({f, offset});
      }
    }
  }
}

algebra::Vector3 PoseCells::Point(size_t cell, const Lattice3& offset) const {
  const auto entry = [&](size_t i) {
    return algebra::Rational(cells_[cell].point[i], denominator_) + algebra::Rational(offset[i]);
  };
  return {entry(0), entry(1), entry(2)};
}

std::array<algebra::Vector3, 2> PoseCells::OtherPoints(size_t cell, const Lattice3& offset) const {
  std::vector<algebra::Vector3> corners;
  for (const Side& side : closures_[cell]) {
    if (cells_[side.cell].dimension != 0) continue;
    const Lattice3& o = side.offset;
    corners.push_back(Point(side.cell, {offset[0] + o[0], offset[1] + o[1], offset[2] + o[2]}));
  }
  if (corners.empty()) return {Point(cell, offset), Point(cell, offset)};
  std::array<algebra::Vector3, 2> points;
  const int n = static_cast<int>(corners.size());
  for (int i = 0; i < n; ++i) {
    points[0] = points[0] + algebra::Rational(2 * (i + 1), n * (n + 1)) * corners[static_cast<size_t>(i)];
    points[1] = points[1] + algebra::Rational(2 * (n - i), n * (n + 1)) * corners[static_cast<size_t>(i)];
  }
  return points;
}

}  // namespace tact::enumerators
