/// @file
/// From a pose in doubles that realises a contact relation nearly to an exact one that realises it.
/// Model   Faces and edges that the contacts involve and that are parallel to kAligned at the pose given are made exactly so:
///         two pairs of aligned faces fix the rotation, one leaves a turn about its normal, an edge in a face leaves turns
///         about both; what is left free is rounded to a rational quaternion. With the rotation known the gaps are linear
///         in the location [thesis, eq. (A.23)]: the solution nearest to the one given, rounded along what is free.
///         The answer is verified by the contact finder.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame F.
/// Exact   the answer; no answer where the contacts ask for an angle whose half has no rational tangent (three contacts
///         of a tilted peg in a hole do in general): `why` says so.
/// Cost    that of one search for contacts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/recognition/point_contact.h"

namespace tact::recognition {

/// Radian: closer than a person can see or a corrected pose can be off, and far more than doubles are.
inline constexpr double kAligned = 1e-5;

struct ExactPose {
  std::optional<algebra::Pose> X_FM;
  algebra::FoundContacts found;        // there, at tolerance zero
  std::vector<PointContact> contacts;  // found
  std::string why;                     // there is none
};

/// At the answer every one of `contacts` has gap zero and nothing penetrates; there may be more contacts than these.
ExactPose FindExactPose(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed,
                        const std::vector<PointContact>& contacts, const joint::Transform& X_FM);

}  // namespace tact::recognition
