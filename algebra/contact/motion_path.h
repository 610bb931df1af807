/// @file
/// Motions of one solid past another along a line or about a fixed axis, and what they touch on the way.
/// Model   X(s), s in [0, 1], carries the moving solid as it is given. A line: translation by s d. A rotation
///         about an axis a through a point: the quaternion (1, s a), so that tan of half the angle is s |a|.
///         w(s) X(s) p is a polynomial of degree 2 in s, w = 1 + s^2 |a|^2 > 0, and so is every event
///         polynomial: a moving vertex over a fixed face's plane, a fixed vertex over a moving face's plane,
///         the reciprocal product of a moving and a fixed edge's line (zero if they meet).
/// Method  Where two solids touch or overlap changes at s only if some pair of vertex and face, or of edge and
///         edge, touches at s whose polynomial vanishes at s but not throughout: any other touching pair keeps
///         touching near s, and pairs of closed elements that are apart stay apart near s. A root inside
///         (0, 1) counts unless a face's plane of one of the solids has the two elements on its two sides
///         there, one of them strictly. Between roots that count one sample decides.
/// Exact   every decision. Poses at rational s are rational.
/// Errors  PreconditionError: a zero direction or axis.
/// Cost    a polynomial for each pair whose swept boxes meet; three or more FindContacts.
#pragma once

#include <optional>
#include <string>

#include "algebra/contact/contact_finder.h"
#include "algebra/exact/quadratic.h"

namespace tact::algebra {

struct MotionPath {
  enum class Kind { kLine, kRotation };
  Kind kind = Kind::kLine;
  Vector3 vector;  // of a line its direction and length, of a rotation the axis a
  Vector3 center;  // of a rotation, a point of the axis

  static MotionPath Line(const Vector3& direction);
  static MotionPath Rotation(const Vector3& point, const Vector3& axis);
  /// Any rational s; At(0) is the identity.
  Pose At(const Rational& s) const;
  friend bool operator==(const MotionPath& a, const MotionPath& b) = default;
};

/// Why a path is not what FollowPath wants: at a parameter, and where it is known, which elements touch there.
struct PathEvent {
  QuadraticRoot parameter;
  std::optional<std::pair<Element, Element>> elements;  // moving, fixed
  std::string what;                                     // a sentence
};

struct PathContacts {
  /// Empty: there is no penetration for s in [0, 1], and the touching pairs of elements are the same for all s
  /// in [0, 1). (Their normals may turn and their points move: the motion DOFs at s = 0 and between may
  /// differ; compare start and middle.)
  std::optional<PathEvent> event;
  FoundContacts start, middle, end;  // at s = 0, 1/2, 1
};

PathContacts FollowPath(const Polyhedron& moving, const Polyhedron& fixed, const MotionPath& path);

}  // namespace tact::algebra
