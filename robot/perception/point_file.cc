#include "robot/perception/point_file.h"

#include <iterator>

#include "algebra/error.h"
#include "robot/cad/text_lines.h"
#include "robot/input/json_stream.h"
#include "robot/perception/surface.h"

namespace tact::perception {

std::vector<Eigen::Vector3d> ReadPoints(std::string_view contents, const std::string& name) {
  cad::TextLines lines(contents, name, true);
  std::vector<Eigen::Vector3d> points;
  std::size_t columns = 0;
  while (lines.Next()) {
    const auto& words = lines.words();
    if (words[0] == "ply" && points.empty())
      lines.Fail("a point a line, x y z (a PLY file has to be written as such text)", "a PLY file");
    if (columns == 0) columns = words.size();
    if (columns < 3) lines.Fail("a point, x y z");
    if (words.size() != columns) lines.Fail(std::to_string(columns) + " numbers as in the lines before");
    for (const std::string_view word : words) lines.CheckNumber(word, nullptr);
    points.emplace_back(*cad::ParseFinite(words[0]), *cad::ParseFinite(words[1]),
                        *cad::ParseFinite(words[2]));
  }
  if (points.size() < kFewestPoints)
    lines.Fail("a scan of at least " + std::to_string(kFewestPoints) + " points, x y z a line",
               points.empty() ? "none" : std::to_string(points.size()));
  return points;
}

std::vector<Eigen::Vector3d> ReadPointFile(const std::string& path) {
  input::InputFile file(path);
  const std::string contents{std::istreambuf_iterator<char>(file.stream()), {}};
  return ReadPoints(contents, file.name());
}

}  // namespace tact::perception
