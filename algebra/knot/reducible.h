/// @file
/// Reducible P-data [thesis, Definition 6]: parts of a rope that cross nothing else.
/// Model   Columns i..j, i < j, not all of them, are closed if their mates are among them; P-data are reducible if there are
///         such. Two intersections interlace if their columns alternate along the rope; the classes that interlacing
///         joins, taken as P-data of their own, are irreducible, and P-data are irreducible just if there is at most one.
///         Part t of Split, by first column, is inserted in one segment of the P-data that parts 1..t-1 make.
/// Planar  The parts of planar P-data are planar; the converse, which [thesis, 5.1.3] needs to put parts together, fails. Put
///         into segment s of Y, X adds a handle beyond those of both just if its ends lie on two faces and s has two faces
///         at its sides. Least counterexample: 3 4 1 2 / 1 2 2 1 in the loop, segment 2, of 2 1 / 1 2.
/// Cost    O(n) for Split, IsIrreducible and Insert.
#pragma once

#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

struct ColumnInterval {
  int first = 0, last = 0;

  friend bool operator==(const ColumnInterval&, const ColumnInterval&) = default;
};

/// Every closed interval, by first, then by last column. Empty: irreducible. O(n^2).
std::vector<ColumnInterval> ClosedIntervals(const PData& p);

/// Not reducible by Definition 6; the straight rope is irreducible.
bool IsIrreducible(const PData& p);

/// For each column from 1 the number of its interlacement class, from 0, by first columns. Index 0 is not used.
std::vector<int> InterlacementClasses(const PData& p);

struct Part {
  PData p;
  int segment = 1;  // where it is inserted in the P-data that the parts before it make

  friend bool operator==(const Part&, const Part&) = default;
};
std::vector<Part> Split(const PData& p);
/// Split's inverse.
PData Join(const std::vector<Part>& parts);

/// Y with the columns of X put into its segment s. PreconditionError: y has no such segment.
PData Insert(const PData& y, int segment, const PData& x);

}  // namespace tact::knot
