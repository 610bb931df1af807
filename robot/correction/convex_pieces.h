/// @file
/// A polyhedron as a union of convex pieces, in doubles.
/// Model   The planes of a solid binary space partition [Naylor, Amanatides and Thibault 1990] cut space into cells; the
///         inner ones are the pieces. Two solids do not penetrate if every two of their pieces have a plane between them,
///         and two convex pieces have one if and only if a face of one, or an edge of each, spans one.
/// Frames  the solid's own.
/// Units   the solid's.
/// Exact   whether a cell is inside; cells thinner than kThin times the solid's size are left out.
/// Cost    O(faces^2) for few faces; once a model.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "algebra/solid/polyhedron.h"

namespace tact::correction {

inline constexpr double kThin = 1e-9;

/// n . x <= offset inside, n outward of length one.
struct HalfSpace {
  Eigen::Vector3d normal;
  double offset = 0;
};

struct ConvexPiece {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<HalfSpace> faces;
  struct Edge {
    size_t tail, head;
    Eigen::Vector3d direction;  // of length one
  };
  std::vector<Edge> edges;
  std::vector<Eigen::Vector3d> directions;  // of the edges, each line once
  Eigen::Vector3d middle;
  double radius = 0;  // of a ball about the middle that holds the piece
};

std::vector<ConvexPiece> ConvexPiecesOf(const algebra::Polyhedron& solid);

/// The sides of a piece's face, as half-spaces whose boundaries stand upright on it.
std::vector<HalfSpace> SidesOf(const ConvexPiece& piece, size_t face);

}  // namespace tact::correction
