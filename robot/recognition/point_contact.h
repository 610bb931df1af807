/// @file
/// Point contacts: the three contact primitives of which every other consists [thesis, 2.7.4], their gaps in doubles.
/// Model   vertex-face, face-vertex (moving element first), and two crossing edges. The gap is the signed distance of the
///         vertex from the face's plane, or of the edges' lines; positive when apart. A contact relation is the set of its
///         point contacts: all of their gaps are zero as long as it is maintained [thesis, eq. (2.9), (A.2), (A.23)].
/// Shapes  a gap's gradient is a row [ p x n | n ] (1 x 6), n the unit separate plane that points to the moving solid, p
///         where it acts; times a twist V_FM_F = [ w ; v ] it is the gap's rate.
/// Frames  the fixed solid's, F; X_FM is the moving solid's pose in it.
/// Units   that of the solids for gaps; a row's first half has it too.
/// Exact   which point contacts there are; gaps are double.
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "algebra/contact/contact_finder.h"
#include "robot/joint/transform.h"

namespace tact::recognition {

enum class PointContactKind { kVertexFace, kFaceVertex, kEdgeEdge };

/// Two elements by their indices in their solids. Edges only: +1 if the cross product of the moving edge with the fixed
/// one (both tail to head) points to the moving solid, -1 if to the fixed one.
struct PointContact {
  PointContactKind kind = PointContactKind::kVertexFace;
  size_t moving = 0, fixed = 0;
  int orientation = 1;
  friend auto operator<=>(const PointContact&, const PointContact&) = default;
};

/// "vertex 3 on face 5", "face 2 on vertex 0", "edge 1 on edge 7".
std::string ToString(const PointContact& contact);

/// The point contacts of contacts found at tolerance zero, sorted: for every separate plane of every contact the vertices
/// and faces in it, and where there are none the crossing edges it comes from. Both solids in place, as they were found.
std::vector<PointContact> PointContactsOf(const algebra::FoundContacts& found,
                                          const algebra::Polyhedron& moving,
                                          const algebra::Polyhedron& fixed);

/// A polyhedron's coordinates in doubles; indices as there.
struct SolidF {
  struct EdgeF {
    Eigen::Vector3d tail, head;
  };
  struct FaceF {
    Eigen::Vector3d normal;  // outward, of length one
    double offset = 0;       // normal . p on the plane
  };
  std::vector<Eigen::Vector3d> vertices;
  std::vector<EdgeF> edges;
  std::vector<FaceF> faces;
};

SolidF ToDouble(const algebra::Polyhedron& solid);

using GapRow = Eigen::Matrix<double, 1, 6>;

struct Gap {
  double gap = 0;
  GapRow row;
  /// Where the contact is, on the moving solid: the vertex (of either), or the point of the edge next to the other.
  Eigen::Vector3d at;
};

/// Edges that are parallel to 1e-12 have the distance of their lines as gap.
Gap GapOf(const PointContact& contact, const SolidF& moving, const SolidF& fixed,
          const joint::Transform& X_FM);

}  // namespace tact::recognition
