/// @file
/// A strict look at a mesh file before a lenient reader takes it: counts, indices, numbers, line by line.
/// Errors  InputError: "name:line: expected ..., got ...".
/// Cost    one pass over the file.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tact::cad {

struct ScreenedMesh {
  std::string contents;               // what the reader gets: colours, comments and tabs may be gone
  size_t points = 0;                  // as declared, or counted where the format declares none
  std::vector<size_t> corners;        // of each polygon
  std::vector<size_t> polygon_lines;  // where each polygon stands; empty for binary files
  std::vector<std::string> notes;
  bool single_precision = false;  // coordinates are floats
  bool shares_points = true;      // polygons refer to points; false if each writes its own
};

ScreenedMesh ScreenOff(std::string_view contents, const std::string& name);
ScreenedMesh ScreenObj(std::string_view contents, const std::string& name);
ScreenedMesh ScreenStl(std::string_view contents, const std::string& name);
ScreenedMesh ScreenPly(std::string_view contents, const std::string& name);

}  // namespace tact::cad
