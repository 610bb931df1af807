// OFF: a header, the counts, a line for each vertex, a line for each face. Colours and normals are dropped.
#include <limits>

#include "robot/cad/mesh_screen.h"
#include "robot/cad/text_lines.h"

namespace tact::cad {
namespace {

constexpr long long kMostItems = std::numeric_limits<int>::max();

bool IsHeader(std::string_view word) {
  for (const std::string_view optional : {"ST", "C", "N"}) {
    if (word.starts_with(optional)) word.remove_prefix(optional.size());
  }
  return word == "OFF";
}

std::vector<std::string_view> ReadCounts(TextLines* lines) {
  if (!lines->Next() || !IsHeader(lines->words()[0])) {
    lines->Fail("an OFF file in text form, starting with OFF, COFF, NOFF or STOFF");
  }
  std::vector<std::string_view> counts(lines->words().begin() + 1, lines->words().end());
  if (counts.empty()) {
    if (!lines->Next()) lines->Fail("the numbers of vertices and faces");
    counts = lines->words();
  }
  if (counts.size() < 2 || counts.size() > 3) lines->Fail("the numbers of vertices, faces and edges");
  return counts;
}

}  // namespace

ScreenedMesh ScreenOff(std::string_view contents, const std::string& name) {
  TextLines lines(contents, name, true);
  ScreenedMesh mesh;
  const std::vector<std::string_view> counts = ReadCounts(&lines);
  const long long points = lines.Whole(counts[0], 1, kMostItems, "a number of vertices");
  const long long faces = lines.Whole(counts[1], 1, kMostItems, "a number of faces");
  mesh.points = static_cast<size_t>(points);
  AppendLine({"OFF"}, &mesh.contents);
  AppendLine({counts[0], counts[1], "0"}, &mesh.contents);

  for (long long i = 0; i < points; ++i) {
    if (!lines.Next() || lines.words().size() < 3) {
      lines.Fail("the three coordinates of vertex " + std::to_string(i + 1) + " of " +
                 std::to_string(points));
    }
    for (size_t k = 0; k < lines.words().size(); ++k) {
      lines.CheckNumber(lines.words()[k], k < 3 ? &mesh.notes : nullptr);
    }
    AppendLine({lines.words().begin(), lines.words().begin() + 3}, &mesh.contents);
  }
  for (long long i = 0; i < faces; ++i) {
    const std::string face = "face " + std::to_string(i + 1) + " of " + std::to_string(faces);
    if (!lines.Next()) lines.Fail(face);
    const auto& words = lines.words();
    const auto corners =
        static_cast<size_t>(lines.Whole(words[0], 0, kMostItems, "a number of corners for " + face));
    if (words.size() < corners + 1) lines.Fail(std::to_string(corners) + " corners for " + face);
    for (size_t k = 1; k <= corners; ++k) lines.Whole(words[k], 0, points - 1, "a vertex, counted");
    for (size_t k = corners + 1; k < words.size(); ++k) lines.CheckNumber(words[k], nullptr);  // a colour
    AppendLine({words.begin(), words.begin() + static_cast<std::ptrdiff_t>(corners) + 1}, &mesh.contents);
    mesh.corners.push_back(corners);
    mesh.polygon_lines.push_back(lines.line());
  }
  if (lines.Next()) lines.Fail("the end of the file after " + std::to_string(faces) + " faces");
  return mesh;
}

}  // namespace tact::cad
