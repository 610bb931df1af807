/// @file
/// Faces in doubles, as a CAD kernel gives them, to an exact polygon soup whose faces are exactly planar.
/// Model   Corners are rounded to kCornerGrid, which undoes the kernel's last digits (-52.4999999999999 is -52.5). If then
///         some faces are not planar (a part that lies askew has no short decimals), their planes are rounded instead, and
///         corners become the points where exact planes meet. Where more than three planes meet askew no point is on all of
///         them, and the face is refused.
/// Units   millimetre.
/// Exact   the soup; a note tells how far corners moved where planes were rounded.
/// Errors  InputError "name: face 12 (#345): ..."
#pragma once

#include <string>
#include <vector>

#include "algebra/solid/polyhedron.h"
#include "robot/cad/step_file.h"

namespace tact::cad {

/// Millimetre: far below what anyone makes or measures, far above the last digit of coordinates up to a kilometre.
inline constexpr double kCornerGrid = 1e-9;
/// Millimetre: kernels call faces planar that are so to 1e-7 mm, exporters that write six decimals of a millimetre to 1e-6;
/// a corner that is farther from its planes was meant to be.
inline constexpr double kMostCornerMove = 1e-4;

struct PlanarFaces {
  algebra::PolygonSoup soup;            // faces with holes are cut into triangles
  std::vector<size_t> face_of_polygon;  // index of the face of each polygon
  std::vector<std::string> notes;
};

PlanarFaces MakePlanar(const std::vector<LoopedFace>& faces, const std::string& name);

}  // namespace tact::cad
