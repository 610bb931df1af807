/// @file
/// The non-linear vision error correction as written [thesis, 2.7.3].
/// Model   f_i(q) = 0 for all point contacts: linearise, take the step of least norm by the singular value decomposition,
///         repeat until the largest |f_i| is small enough. It looks at nothing else: whether the elements meet, or the
///         solids overlap, is found out afterwards.
/// Open    in the text, and here an option: what q is, that is how much a radian counts in a step's norm and about which
///         point the object turns; below which singular value a direction counts as free; when to stop.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame.
/// Units   the solids' length; radian.
#pragma once

#include "robot/correction/contact_problem.h"

namespace tact::correction {

struct GaussNewtonOptions {
  /// Lengths that a radian counts as in a step's norm. The literal one: q is location in the models' unit and rotation
  /// in radians, both bare numbers. A unit quaternion instead of the angles counts half of it.
  double radian = 1;
  /// The object turns about its own frame's origin, or about the fixed frame's.
  bool about_object = true;
  /// Singular values below this, times the largest, are zero: only the rounding of doubles.
  double cutoff = 1e-12;
  /// In the solids' unit, times their size: the largest |f_i| that is small enough.
  double enough = 1e-8;
  int iterations = 100;
};

struct GaussNewtonAnswer {
  joint::Transform X_FM;
  Outcome outcome = Outcome::kNotConverged;
  int iterations = 0;
};

GaussNewtonAnswer CorrectByGaussNewton(const Models& models,
                                       const std::vector<recognition::PointContact>& contacts,
                                       const joint::Transform& X_FM, const GaussNewtonOptions& options = {});

}  // namespace tact::correction
