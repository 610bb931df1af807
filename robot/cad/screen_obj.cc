// OBJ: vertices and faces in any order; a face's corner is vertex, vertex/texture, vertex//normal or all
// three, counted from 1, or from -1 backwards. Everything else is passed over if it cannot change the solid.
#include <algorithm>
#include <array>
#include <limits>

#include "robot/cad/mesh_screen.h"
#include "robot/cad/text_lines.h"

namespace tact::cad {
namespace {

constexpr std::array<std::string_view, 10> kPassedOver = {"vt", "vn",     "vp",     "o",  "g",
                                                          "s",  "mtllib", "usemtl", "mg", "usemap"};
constexpr long long kMostItems = std::numeric_limits<int>::max();

void CheckCorner(const TextLines& lines, std::string_view corner, long long points) {
  const std::string_view index = corner.substr(0, corner.find('/'));
  const bool backwards = index.starts_with('-');
  lines.Whole(index, backwards ? -points : 1, backwards ? -1 : kMostItems, "a vertex, counted");
  std::string_view rest = corner.substr(index.size());
  for (int slashes = 0; !rest.empty(); ++slashes) {
    rest.remove_prefix(1);
    const std::string_view other = rest.substr(0, rest.find('/'));
    if (slashes == 2) lines.Fail("a corner as vertex/texture/normal", "\"" + std::string(corner) + "\"");
    if (!other.empty()) lines.Whole(other, -kMostItems, kMostItems, "a texture or normal index");
    rest.remove_prefix(other.size());
  }
}

}  // namespace

ScreenedMesh ScreenObj(std::string_view contents, const std::string& name) {
  TextLines lines(contents, name, true);
  ScreenedMesh mesh;
  long long points = 0, highest = 0;
  size_t highest_line = 0;
  while (lines.Next()) {
    const auto& words = lines.words();
    if (words.back().ends_with('\\')) lines.Fail("a whole statement on each line");
    if (words[0] == "v") {
      if (words.size() < 4) lines.Fail("v and three coordinates");
      for (size_t k = 1; k < words.size(); ++k) {
        lines.CheckNumber(words[k], k < 4 ? &mesh.notes : nullptr);
      }
      AppendLine({words.begin(), words.begin() + 4}, &mesh.contents);
      ++points;
    } else if (words[0] == "f") {
      for (size_t k = 1; k < words.size(); ++k) {
        CheckCorner(lines, words[k], points);
        const long long index =
            lines.Whole(words[k].substr(0, words[k].find('/')), -points, kMostItems, "a vertex, counted");
        if (index > highest) {
          highest = index;
          highest_line = lines.line();
        }
      }
      AppendLine(words, &mesh.contents);
      mesh.corners.push_back(words.size() - 1);
      mesh.polygon_lines.push_back(lines.line());
    } else if (std::find(kPassedOver.begin(), kPassedOver.end(), words[0]) == kPassedOver.end()) {
      lines.Fail("a statement that describes polygons (v, f, o, g, s, vt, vn, usemtl, mtllib)");
    }
  }
  if (points == 0) lines.Fail("at least one vertex (v x y z)");
  if (mesh.corners.empty()) lines.Fail("at least one face (f i j k)");
  if (highest > points) {
    TextLines again(contents, name, true);
    while (again.line() < highest_line) again.Next();
    again.Fail("vertices, counted from 1 to " + std::to_string(points));
  }
  mesh.points = static_cast<size_t>(points);
  return mesh;
}

}  // namespace tact::cad
