/// @file
/// A contact relation between two solids as equalities and inequalities in the pose, and whether a pose satisfies it.
/// Model   The relation is its point contacts: each has no gap, and touches within its elements: the vertex within a convex
///         part of the face, the crossing within both edges. The solids do not penetrate if every two of their convex
///         pieces have a plane between them.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame.
/// Units   the solids' length, called unit here; radian.
/// Exact   no.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/correction/contact_functions.h"
#include "robot/correction/convex_pieces.h"
#include "robot/recognition/point_contact.h"

namespace tact::correction {

/// A gap, an overlap or a place beyond an edge below this, times the models' size, is none: far below what any camera or
/// machine tells apart, far above the rounding of doubles.
inline constexpr double kTouching = 1e-6;

struct Solid {
  recognition::SolidF elements;
  std::vector<ConvexPiece> pieces;
  /// Of each face, its convex parts by their sides.
  std::vector<std::vector<std::vector<HalfSpace>>> face_parts;
};

struct Models {
  Solid moving, fixed;
  double size =
      0;  // the largest distance of a moving vertex from the moving frame's origin, or from one another
};

Models ModelsOf(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed);

struct Relation {
  std::vector<recognition::PointContact> contacts;
  std::optional<joint::Transform> realisation;  // a pose that satisfies it
};

enum class Outcome {
  kCorrected,
  kDiverged,       // the iteration left every sensible pose
  kNotConverged,   // gaps remain after all iterations
  kGapRemains,     // the method ended at its answer, which does not have the contacts
  kElementsApart,  // no gaps, but somewhere a vertex or an edge left the face or the edge that it should touch
  kPenetrates,     // contacts as wanted, and solids that overlap elsewhere
  kNoRealisation,  // the method needs a realisation and has none
};
std::string ToString(Outcome outcome);

/// kCorrected, kGapRemains, kElementsApart or kPenetrates; `tolerance` is a length.
Outcome Judge(const Models& models, const std::vector<recognition::PointContact>& contacts,
              const joint::Transform& X_FM, double tolerance);
Outcome Judge(const Models& models, const std::vector<recognition::PointContact>& contacts,
              const joint::Transform& X_FM);

Feature GapFeature(const recognition::PointContact& contact, const Models& models);

/// That the contact is within its elements; of a face, within that part whose sides it lies farthest inside of.
std::vector<Feature> WithinFeatures(const recognition::PointContact& contact, const Models& models,
                                    const joint::Transform& X_FM);

/// The widest gap between two pieces that a plane along a face of one, or along an edge of each, leaves open; negative if
/// they overlap. The features that keep it open: those among them whose gap is less than `near` above it.
struct Separation {
  double gap = 0;
  FeatureKind kind = FeatureKind::kVertexFace;
  size_t first = 0, second = 0;  // the face; or the directions of the two edges
  double sign = 1;
};
Separation Widest(const ConvexPiece& moving, const ConvexPiece& fixed, const joint::Transform& X_FM);
std::vector<Feature> SeparationFeatures(const ConvexPiece& moving, const ConvexPiece& fixed,
                                        const joint::Transform& X_FM, const Separation& separation,
                                        double near);

/// At most what keeps the pieces' balls apart.
double BallGap(const ConvexPiece& moving, const ConvexPiece& fixed, const joint::Transform& X_FM);

}  // namespace tact::correction
