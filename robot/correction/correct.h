/// @file
/// Vision error correction by any of its methods.
/// Frames  X_FM is the moving solid's pose in the fixed one's frame.
/// Units   the solids' length; radian.
#pragma once

#include <string>

#include "robot/correction/nearest_pose.h"

namespace tact::correction {

enum class Method {
  kGaussNewton,           // gauss_newton.h, as written
  kLinear,                // linear_correction.h; needs a realisation
  kNearest,               // nearest_pose.h
  kNearestRotationFirst,  // the same, the least turn first
};
/// "non-linear", "linear", "nearest", "nearest, rotation first".
std::string ToString(Method method);

struct Correction {
  joint::Transform X_FM;
  double rotation = 0, translation = 0;  // displacement, of the moving frame
  Outcome outcome = Outcome::kNotConverged;
};

/// The answer's displacement means something only if the outcome is kCorrected.
Correction Correct(Method method, const Models& models, const Relation& relation,
                   const joint::Transform& X_FM);

}  // namespace tact::correction
