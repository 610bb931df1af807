// STL: triangles that each write their own points. Binary if the length is what the count in it says.
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "algebra/error.h"
#include "robot/cad/mesh_screen.h"
#include "robot/cad/text_lines.h"

namespace tact::cad {
namespace {

constexpr size_t kHeader = 80, kCount = 4, kTriangle = 50;

uint32_t LittleEndian32(std::string_view contents, size_t offset) {
  uint32_t value = 0;
  for (size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(contents[offset + i]);
  return value;
}

ScreenedMesh ScreenBinary(std::string_view contents, const std::string& name) {
  if (contents.size() < kHeader + kCount) {
    throw InputError(
        name + ": expected an STL file, as text starting with \"solid\" or as binary of at least " +
        std::to_string(kHeader + kCount) + " bytes, got " + std::to_string(contents.size()) + " bytes");
  }
  const size_t triangles = LittleEndian32(contents, kHeader);
  const size_t expected = kHeader + kCount + kTriangle * triangles;
  if (triangles == 0) throw InputError(name + ": expected at least one triangle, got none");
  if (contents.size() != expected) {
    throw InputError(name + ": expected " + std::to_string(expected) + " bytes for " +
                     std::to_string(triangles) + " triangles, got " + std::to_string(contents.size()));
  }
  for (size_t i = 0; i < triangles; ++i) {
    for (size_t k = 3; k < 12; ++k) {
      const size_t offset = kHeader + kCount + kTriangle * i + 4 * k;
      if (std::isfinite(std::bit_cast<float>(LittleEndian32(contents, offset)))) continue;
      throw InputError(name + ": face " + std::to_string(i + 1) +
                       ": expected finite coordinates, got NaN or infinity");
    }
  }
  ScreenedMesh mesh;
  mesh.contents = contents;
  mesh.contents.replace(0, kHeader, kHeader,
                        '-');  // a header may say "solid", which means text to the reader
  mesh.corners.assign(triangles, 3);
  mesh.points = 3 * triangles;
  mesh.single_precision = true;
  mesh.shares_points = false;
  return mesh;
}

void Expect(TextLines* lines, std::initializer_list<std::string_view> start, size_t numbers,
            std::vector<std::string>* notes) {
  std::string expected;
  for (const std::string_view word : start) expected += (expected.empty() ? "" : " ") + std::string(word);
  if (numbers > 0) expected += " and three numbers";
  if (!lines->Next() || lines->words().size() != start.size() + numbers ||
      !std::equal(start.begin(), start.end(), lines->words().begin())) {
    lines->Fail("\"" + expected + "\"");
  }
  for (size_t k = start.size(); k < lines->words().size(); ++k) lines->CheckNumber(lines->words()[k], notes);
}

ScreenedMesh ScreenText(std::string_view contents, const std::string& name) {
  TextLines lines(contents, name, false);
  ScreenedMesh mesh;
  mesh.shares_points = false;
  bool in_solid = false;
  while (lines.Next()) {
    const auto& words = lines.words();
    if (words[0] == (in_solid ? "endsolid" : "solid")) {
      in_solid = !in_solid;
      AppendLine({words[0]}, &mesh.contents);  // names are dropped: the reader takes any word for a keyword
      continue;
    }
    if (!in_solid || words[0] != "facet") {
      lines.Fail(in_solid ? "\"facet normal\" or \"endsolid\"" : "\"solid\" or the end of the file");
    }
    if (words.size() != 5 || words[1] != "normal") lines.Fail("\"facet normal\" and three numbers");
    mesh.polygon_lines.push_back(lines.line());
    mesh.contents += "facet normal 0 0 0\nouter loop\n";  // a normal follows from the corners; some write nan
    Expect(&lines, {"outer", "loop"}, 0, nullptr);
    for (int k = 0; k < 3; ++k) {
      Expect(&lines, {"vertex"}, 3, &mesh.notes);
      AppendLine(lines.words(), &mesh.contents);
    }
    Expect(&lines, {"endloop"}, 0, nullptr);
    Expect(&lines, {"endfacet"}, 0, nullptr);
    mesh.contents += "endloop\nendfacet\n";
    mesh.corners.push_back(3);
  }
  if (in_solid) lines.Fail("\"facet normal\" or \"endsolid\"");
  if (mesh.corners.empty()) lines.Fail("at least one facet");
  mesh.points = 3 * mesh.corners.size();
  return mesh;
}

}  // namespace

ScreenedMesh ScreenStl(std::string_view contents, const std::string& name) {
  const bool has_binary_length =
      contents.size() >= kHeader + kCount &&
      contents.size() == kHeader + kCount + kTriangle * LittleEndian32(contents, kHeader);
  const size_t start = contents.find_first_not_of(" \t\r\n");
  const bool says_solid = start != std::string_view::npos && contents.substr(start).starts_with("solid");
  return says_solid && !has_binary_length ? ScreenText(contents, name) : ScreenBinary(contents, name);
}

}  // namespace tact::cad
