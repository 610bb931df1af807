/// @file
/// STEP files (ISO 10303-21) as faces in doubles, by OpenCASCADE, which is loaded when the first one is read
/// (step/step_module.h).
/// Model   every face of the file's shapes, in their order, as boundary loops of straight edges. A face numbered 12 is the
///         12th; #345 is its line in the file where that is known.
/// Units   millimetre: the file names its unit, and lengths are converted.
/// Exact   no; planar_faces.h makes them so.
/// Errors  InputError "name: ...": contents that are no STEP file or end early; a file without faces; a face that is not
///         planar, named as what it is; an edge that is not straight.
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace tact::cad {

struct LoopedFace {
  std::vector<std::vector<Eigen::Vector3d>> loops;  // the outer one first; in any sense
  Eigen::Vector3d normal;                           // outward, of length one
  std::string name;                                 // "face 12 (#345)"
};

/// name stands for the file in errors.
std::vector<LoopedFace> ReadStepFaces(std::string_view contents, const std::string& name);

}  // namespace tact::cad
