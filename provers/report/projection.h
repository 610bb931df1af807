/// @file
/// Orthographic views of exact points, for drawings: from here on double.
/// Frames  view coordinates: x to the right, y up, z toward the viewer, in the points' unit.
#pragma once

#include <array>

#include "algebra/screw/vector3.h"

namespace tact::provers {

/// From where to look. The default is axonometric, from the front right, above.
struct View {
  std::array<double, 3> toward_viewer{0.55, -1, 0.6};
  std::array<double, 3> up{0, 0, 1};
  double width = 560, height = 380;  // the most the drawing may take, in pixels
};

/// The flat view against an axis: 'x' shows y to the right and z up, 'y' shows x and z, 'z' shows x and y.
/// PreconditionError: another letter.
View AlongAxis(char axis);

/// A point in view coordinates.
struct ViewPoint {
  double x = 0, y = 0, z = 0;
};

class Projection {
 public:
  /// PreconditionError: `toward_viewer` is zero or parallel to `up`.
  explicit Projection(const View& view);

  ViewPoint operator()(const algebra::Vector3& v) const;
  ViewPoint At(const std::array<double, 3>& v) const;
  /// The same way, of unit length, however large the entries. PreconditionError: v is zero.
  ViewPoint Direction(const algebra::Vector3& v) const;

 private:
  std::array<double, 3> right_, up_, toward_viewer_;
};

}  // namespace tact::provers
