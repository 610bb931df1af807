/// @file
/// Movement primitives of a rope's diagram, read from a certificate and judged by corners: a kink, a lens or a triangle is a
/// face of one, two or three corners.
/// Model   A move that adds is judged as the one that takes away what it added. Segments are counted in the code with fewer
///         columns: R1 at i adds columns i, i+1; R2 at i <= j columns i, i+1, j+2, j+3; Cross of the selective end over or
///         under i columns 1, i+1, of the other end columns i, n; R3 of A (over both), B, C (under both) shifts.
/// Errors  Refused.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "provers/check/knot_code.h"

namespace tact::check {

struct KnotMove {
  std::string kind;       // R1, R2, R3, Cross
  std::string direction;  // add, remove, shift
  std::array<int, 3> segments{};
  int attr = 0;            // R1, R2: of the first new column; Cross: of the end's column
  bool opposite = false;   // R2: the strands meet the two intersections in opposite order
  bool selective = false;  // Cross
};

/// {"kind":"R2","direction":"add","segments":[1,4],"end":null,"selective_end":"same","attr":1,"order":"same"}: "end" is null but for
/// Cross, "order" but for R2, "attr" for R3.
KnotMove ReadKnotMove(const Value& value);
/// Refuses, at `where`, a move that is not possible or leads elsewhere. Precondition: both codes lie on a sphere.
void ExpectMoveLeads(const Value& where, const KnotCode& before, const KnotMove& move, const KnotCode& after);

/// Whether taking some lens with one strand over the other out of `larger` gives `smaller`.
bool AnyLensLeads(const KnotCode& larger, const KnotCode& smaller);
/// Whether shifting some triangle of `before` gives `after`.
bool AnyTriangleLeads(const KnotCode& before, const KnotCode& after);

/// Whether the three segments bound a face of three corners. Precondition: segments from 2 to n.
bool BoundsTriangle(const KnotCode& code, const std::array<int, 3>& segments);
/// The code without the columns, numbers closed up. Precondition: ascending, each with its mate.
KnotCode WithoutColumns(const KnotCode& code, const std::vector<int>& columns);

}  // namespace tact::check
