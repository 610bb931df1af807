/// @file
/// The cells of a periodic arrangement of planes: translations at which the same pairs of elements touch.
/// Model   Two solids with integer corners, one of them translated by t. Where they touch or overlap is decided by the
///         signs of n . t - c, n a face's normal of either or the product of an edge's direction of each, c an
///         integer: a vertex over a plane, or two edges' lines past one another. So it is the same throughout a cell of the
///         arrangement { n . t is an integer }. With axis-parallel faces only the cells are products of integers
///         and open unit intervals. A cell f is in the closure of a cell g if and only if each n . t that is an
///         integer on g is the same on f, and each that lies between two integers on g does so on f or is one of them.
/// Method  A cell of dimension k holds the centre of k + 1 of its corners. Corners' denominators divide the determinants of
///         three normals; so, with L their least common multiple, every cell has a point with denominator 12 L. All
///         such points of the unit cube are looked at once, simple ones first.
/// Exact   integer arithmetic.
/// Errors  PreconditionError: normals that are not integer, or the coordinate axes not among them.
#pragma once

#include <array>
#include <vector>

#include "algebra/screw/vector3.h"
#include "algebra/solid/polyhedron.h"

namespace tact::enumerators {

using Lattice3 = std::array<int, 3>;

/// The primitive normals of the planes at which two solids' contacts change, each once, up to sign.
std::vector<Lattice3> EventNormals(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed);

class PoseCells {
 public:
  /// A cell of the unit cube [0, 1)^3; all others are these, moved by integers.
  struct Cell {
    Lattice3 point;  // of its relative interior, times denominator()
    int dimension = 0;
    std::vector<int> floors;  // per normal twice the floor of n . t, and one more if that is no integer
  };
  /// A cell in another's closure: cells()[cell] moved by `offset`.
  struct Side {
    size_t cell = 0;
    Lattice3 offset;
  };

  explicit PoseCells(std::vector<Lattice3> normals);

  const std::vector<Cell>& cells() const { return cells_; }
  int denominator() const { return denominator_; }
  /// The cells in the closure of one of the unit cube, itself left out.
  const std::vector<Side>& Closure(size_t cell) const { return closures_[cell]; }
  algebra::Vector3 Point(size_t cell, const Lattice3& offset) const;
  /// Two more points of the cell, in general position there: its corners with weights 1, 2, ... and ..., 2, 1.
  std::array<algebra::Vector3, 2> OtherPoints(size_t cell, const Lattice3& offset) const;

 private:
  Cell CellAt(const Lattice3& point) const;
  void FindCells();
  void FindClosures();

  std::vector<Lattice3> normals_;
  int denominator_ = 1;
  std::vector<Cell> cells_;
  std::vector<std::vector<Side>> closures_;
};

}  // namespace tact::enumerators
