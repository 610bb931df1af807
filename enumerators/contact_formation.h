/// @file
/// Contact formations of two solids, one translated past the other, and which borders on which.
/// Model   A formation is a connected set of translations at which the same pairs of elements touch and nothing overlaps; it
///         is a union of cells (pose_cells.h). Formation B borders on A if it is in the closure of A: an infinitesimal
///         translation inside A, a free motion that keeps A's contacts, ends in B, and A's pairs of elements are
///         within B's [Donald 1985]. Borders depend on the solids' shapes only, not on how many cells a formation is
///         cut into: near a cell that is one of several of its formation, all is the same along the formation.
/// Frames  contacts in the fixed solid's frame.
/// Exact   everything.
/// Cost    a FindContacts for each cell within reach: some 50 microseconds each.
#pragma once

#include <optional>
#include <vector>

#include "algebra/contact/contact_finder.h"
#include "algebra/contact/motion_dof.h"

namespace tact::enumerators {

using ElementPairs = std::vector<std::pair<algebra::Element, algebra::Element>>;  // moving, fixed; sorted

/// The pairs of elements at the corners of the contact region, each once.
ElementPairs PairsOf(const algebra::FoundContacts& found);

struct Formation {
  ElementPairs pairs;  // empty: free
  int dimension = 0;   // of its set of translations
  algebra::Vector3 pose;
  algebra::ContactRelation relation;  // at that pose
  algebra::MotionDof dof;
  size_t cells = 0;
  /// Somewhere else it has other motion DOFs: the elements that touch do not decide how their points lie. Looked at is
  /// a point in each cell, and two more in the first of the largest.
  bool uneven = false;
};

/// `border` is in the closure of `open`, here at these two poses.
struct Border {
  size_t open = 0, border = 0;
  algebra::Vector3 open_pose, border_pose;
};

struct FormationComplex {
  std::vector<Formation> formations;  // by their first cell
  std::vector<Border> borders;        // by open, then border
  size_t cells = 0;                   // without overlap, touching or not
};

/// Precondition: integer corners, of solids whose edges and faces give small normals, and some axis-parallel box among them
/// (see EventNormals).
FormationComplex FindFormations(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed);

}  // namespace tact::enumerators
