/// @file
/// CAD files as exact polyhedra: OFF, OBJ, STL and PLY meshes, the latter two as text and binary, and STEP.
/// Model   the file's polygons must bound solids as algebra/solid/polyhedron.h says; nothing is repaired.
/// Units   a mesh names none: the caller says which unit the file is in and which one is wanted. A STEP file does; then what
///         the caller says of it is ignored.
/// Exact   a number in text is the decimal that a double of it prints as, 15 digits are always kept; a number
///         of single precision is the shortest decimal that a float of it prints as. A note tells of a text
///         number that this changed. STEP: planar_faces.h.
/// Errors  InputError: "file:line: expected ..., got ...", and "file:line: face K: ..." for polygons that
///         bound no solid; faces are counted from 1, lines are left out for binary files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algebra/solid/polyhedron.h"
#include "robot/cad/length_unit.h"

namespace tact::cad {

enum class MeshFormat { kOff, kObj, kStl, kPly, kStep };

struct Mesh {
  algebra::Polyhedron solid;
  std::vector<std::string> notes;
};

/// The format that a file's extension names, in upper or lower case. Throws InputError.
MeshFormat MeshFormatOf(const std::string& path);

/// The polyhedron in a file, its lengths in target.
Mesh ReadMesh(const std::string& path, LengthUnit unit, LengthUnit target);

/// The same of a file's contents; name stands for the file in errors.
Mesh ReadMesh(std::string_view contents, MeshFormat format, const std::string& name, LengthUnit unit,
              LengthUnit target);

}  // namespace tact::cad
