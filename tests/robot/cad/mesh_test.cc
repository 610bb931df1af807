#include "robot/cad/mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "algebra/error.h"

namespace tact::cad {
namespace {

using algebra::Convexity;
using algebra::Rational;
using algebra::SixfoldVolume;

constexpr LengthUnit kMm = LengthUnit::kMillimetre;

const char kTetrahedronOff[] = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

std::string Contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

std::string Refusal(std::string_view contents, MeshFormat format) {
  try {
    ReadMesh(contents, format, "file", kMm, kMm);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

void ExpectTetrahedron(const Mesh& mesh) {
  EXPECT_EQ(mesh.solid.vertices.size(), 4u);
  EXPECT_EQ(mesh.solid.edges.size(), 6u);
  EXPECT_EQ(mesh.solid.faces.size(), 4u);
  EXPECT_EQ(SixfoldVolume(mesh.solid), Rational(1));
}

// The tetrahedron's triangles, corner by corner.
std::vector<std::vector<float>> Triangles() {
  const float p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  std::vector<std::vector<float>> triangles;
  for (const auto& t : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    auto& corners = triangles.emplace_back();
    for (const int i : t) corners.insert(corners.end(), p[i], p[i] + 3);
  }
  return triangles;
}

std::string BinaryStl(const std::string& header) {
  std::string text = header + std::string(80 - header.size(), ' ') + std::string("\4\0\0\0", 4);
  for (const auto& triangle : Triangles()) {
    text += std::string(12, '\0');
    for (const float x : triangle) text += std::string(reinterpret_cast<const char*>(&x), 4);
    text += std::string(2, '\0');
  }
  return text;
}

TEST(Mesh, OffIsReadWithCommentsColoursAndCountsOnTheFirstLine) {
  ExpectTetrahedron(ReadMesh(kTetrahedronOff, MeshFormat::kOff, "t", kMm, kMm));
  ExpectTetrahedron(
      ReadMesh("# made by hand\r\nCOFF 4 4 0\r\n\r\n0 0 0 255 0 0 255\r\n1 0 0 0 0 0 0\r\n"
               "0\t1\t0 1 1 1 1 # third\r\n0 0 1 1 1 1 1\r\n3 0 2 1 255 0 0\r\n3  0 1 3\r\n"
               "3 1 2 3\r\n3 2 0 3",
               MeshFormat::kOff, "t", kMm, kMm));
}

TEST(Mesh, ObjIsReadWithTexturesNormalsAndBackwardIndices) {
  ExpectTetrahedron(
      ReadMesh("o t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\nf 1/1/1 3/1/1 2/1/1\nv 0 0 1\n"
               "f\t1//1\t2//1 4//1\nf -3/1 -2/1 -1/1\nf 3 1 4\n",
               MeshFormat::kObj, "t", kMm, kMm));
}

TEST(Mesh, TextAndBinaryStlAreRead) {
  std::ostringstream text;
  text << "solid facet vertex\n";
  for (const auto& t : Triangles()) {
    text << "facet normal nan 0 0\n outer loop\n";
    for (size_t i = 0; i < 9; i += 3)
      text << "  vertex " << t[i] << " " << t[i + 1] << " " << t[i + 2] << "\n";
    text << " endloop\nendfacet\n";
  }
  text << "endsolid\n";
  ExpectTetrahedron(ReadMesh(text.str(), MeshFormat::kStl, "t", kMm, kMm));
  ExpectTetrahedron(ReadMesh(BinaryStl("made by hand"), MeshFormat::kStl, "t", kMm, kMm));
  ExpectTetrahedron(ReadMesh(BinaryStl("solid made by hand"), MeshFormat::kStl, "t", kMm, kMm));
}

std::string Ply(const std::string& format) {
  return "ply\nformat " + format +
         " 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\nproperty float y\nproperty float "
         "z\n"
         "property uchar red\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string BinaryPly(bool big_endian) {
  std::string text = Ply(big_endian ? "binary_big_endian" : "binary_little_endian");
  const auto append = [&](const auto& value) {
    std::string bytes(reinterpret_cast<const char*>(&value), sizeof value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    text += bytes;
  };
  for (const auto& p : {std::array{0.f, 0.f, 0.f}, {1.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, {0.f, 0.f, 1.f}}) {
    for (const float x : p) append(x);
    text += '\7';
  }
  for (const auto& t : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}) {
    text += '\3';
    for (const int i : t) append(i);
  }
  return text;
}

TEST(Mesh, TextAndBinaryPlyAreRead) {
  ExpectTetrahedron(
      ReadMesh(Ply("ascii") + "0 0 0 9\n1 0 0 9\n0 1 0 9\n0 0 1 9\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n",
               MeshFormat::kPly, "t", kMm, kMm));
  ExpectTetrahedron(ReadMesh(BinaryPly(false), MeshFormat::kPly, "t", kMm, kMm));
  ExpectTetrahedron(ReadMesh(BinaryPly(true), MeshFormat::kPly, "t", kMm, kMm));
}

TEST(Mesh, EveryCutOfAFileIsRefused) {
  const std::string off = kTetrahedronOff;
  for (size_t n = 0; n + 2 < off.size(); ++n) EXPECT_NE(Refusal(off.substr(0, n), MeshFormat::kOff), "") << n;
  const std::string stl = BinaryStl("x");
  for (size_t n = 0; n < stl.size(); ++n) EXPECT_NE(Refusal(stl.substr(0, n), MeshFormat::kStl), "") << n;
  const std::string ply = BinaryPly(true);
  for (size_t n = 0; n < ply.size(); ++n) EXPECT_NE(Refusal(ply.substr(0, n), MeshFormat::kPly), "") << n;
}

TEST(Mesh, BytesAfterABinaryMeshAreRefused) {
  EXPECT_NE(Refusal(BinaryStl("x") + "y", MeshFormat::kStl), "");
  EXPECT_NE(Refusal(BinaryPly(false) + "y", MeshFormat::kPly), "");
}

TEST(Mesh, NotANumberInABinaryMeshIsRefusedAndNamed) {
  std::string stl = BinaryStl("x");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  std::memcpy(stl.data() + 84 + 50 + 12, &nan, 4);
  EXPECT_EQ(Refusal(stl, MeshFormat::kStl), "file: face 2: expected finite coordinates, got NaN or infinity");
}

TEST(Mesh, DecimalsAreTakenAsWrittenAndUnitsScaleExactly) {
  const std::string off = "OFF 4 4 0\n0 0 0\n0.1 0 0\n0 0.1 0\n0 0 0.1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
  const auto along_x = [&](LengthUnit unit, LengthUnit target) {
    return ReadMesh(off, MeshFormat::kOff, "t", unit, target).solid.vertices[1].point.x;
  };
  EXPECT_EQ(along_x(kMm, kMm), Rational(1, 10));
  EXPECT_EQ(along_x(LengthUnit::kMetre, kMm), Rational(100));
  EXPECT_EQ(along_x(LengthUnit::kCentimetre, LengthUnit::kMetre), Rational(1, 1000));
  EXPECT_EQ(along_x(LengthUnit::kInch, kMm), Rational(127, 50));
  const Mesh inches = ReadMesh(off, MeshFormat::kOff, "t", LengthUnit::kInch, kMm);
  for (const auto& face : inches.solid.faces) {
    for (const size_t v : face.loops[0]) {
      EXPECT_EQ(Dot(face.normal, inches.solid.vertices[v].point), face.offset);
    }
  }
}

TEST(Mesh, SinglePrecisionIsTheShortestDecimalOfAFloat) {
  std::string stl = BinaryStl("x");
  for (size_t offset = 84; offset + 50 <= stl.size(); offset += 50) {
    for (size_t k = 3; k < 12; ++k) {
      float x = 0;
      std::memcpy(&x, stl.data() + offset + 4 * k, 4);
      x *= 0.1f;
      std::memcpy(stl.data() + offset + 4 * k, &x, 4);
    }
  }
  EXPECT_EQ(SixfoldVolume(ReadMesh(stl, MeshFormat::kStl, "t", kMm, kMm).solid), Rational(1, 1000));
}

TEST(Mesh, NumbersThatADoubleCannotKeepAreNoted) {
  std::string off = kTetrahedronOff;
  off.replace(off.find("1 0 0"), 5, "1.00000000000000000001 0 0");
  const Mesh mesh = ReadMesh(off, MeshFormat::kOff, "file", kMm, kMm);
  ASSERT_EQ(mesh.notes.size(), 1u);
  EXPECT_EQ(mesh.notes[0], "file:4: \"1.00000000000000000001\" has 21 significant digits and is taken as 1");
  EXPECT_TRUE(ReadMesh(kTetrahedronOff, MeshFormat::kOff, "file", kMm, kMm).notes.empty());
}

TEST(Mesh, FormatsAreKnownByTheirExtensionInAnyCase) {
  EXPECT_EQ(MeshFormatOf("a.b/c.OFF"), MeshFormat::kOff);
  EXPECT_EQ(MeshFormatOf("c.Obj"), MeshFormat::kObj);
  EXPECT_THROW(MeshFormatOf("off"), InputError);
  EXPECT_EQ(MeshFormatOf("c.STP"), MeshFormat::kStep);
  EXPECT_EQ(MeshFormatOf("c.step"), MeshFormat::kStep);
  EXPECT_THROW(MeshFormatOf("c.iges"), InputError);
  EXPECT_THROW(ReadMesh("no-such-file.off", kMm, kMm), InputError);
}

// bad/NAME.EXT and bad/NAME.expected, the message without the folder.
TEST(Mesh, EveryBadFileIsRefusedWithItsMessage) {
  const std::filesystem::path folder = std::filesystem::path(TACT_SOURCE_DIR) / "tests/robot/cad/bad";
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".expected" || extension == ".md") continue;
    ++files;
    std::filesystem::path expected = entry.path();
    expected.replace_extension(".expected");
    std::string wanted = Contents(expected), got = "accepted";
    if (wanted.ends_with('\n')) wanted.pop_back();
    try {
      ReadMesh(entry.path().string(), kMm, kMm);
    } catch (const InputError& error) {
      got = error.what();
      if (got.starts_with(folder.string() + "/")) got.erase(0, folder.string().size() + 1);
    }
    EXPECT_EQ(got, wanted) << entry.path();
  }
  EXPECT_GE(files, 30);
}

struct RealModel {
  const char* path;
  LengthUnit unit;
  size_t vertices, edges, faces, shells, concave;
  Rational volume;  // mm^3
};
void PrintTo(const RealModel& model, std::ostream* out) { *out << model.path; }

class MeshOfRealModel : public testing::TestWithParam<RealModel> {};

TEST_P(MeshOfRealModel, IsReadWithEveryCornerEdgeAndFace) {
  const RealModel& model = GetParam();
  const std::string path = std::string(TACT_SOURCE_DIR) + "/../shared/data/" + model.path;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is absent";
  const Mesh mesh = ReadMesh(path, model.unit, kMm);
  EXPECT_EQ(mesh.solid.vertices.size(), model.vertices);
  EXPECT_EQ(mesh.solid.edges.size(), model.edges);
  EXPECT_EQ(mesh.solid.faces.size(), model.faces);
  EXPECT_EQ(mesh.solid.shells, model.shells);
  EXPECT_EQ(SixfoldVolume(mesh.solid), Rational(6) * model.volume);
  EXPECT_EQ(
      static_cast<size_t>(std::count_if(mesh.solid.edges.begin(), mesh.solid.edges.end(),
                                        [](const auto& e) { return e.convexity == Convexity::kConcave; })),
      model.concave);
}

// By hand: prisms over the drawings' outlines; caps are a cube with a prism set on it, bottles a cube less
// one.
INSTANTIATE_TEST_SUITE_P(
    SharedData, MeshOfRealModel,
    testing::Values(RealModel{"peg_in_hole/peg.off", kMm, 16, 24, 10, 1, 2, 35 * (35 * 70 + 70 * 18)},
                    RealModel{"peg_in_hole/hole.off", kMm, 24, 36, 14, 1, 4, 35 * (140 * 18 + 2 * 35 * 70)},
                    RealModel{"pegs/objects_2mm_Line_cube_cap.obj", LengthUnit::kMetre, 16, 24, 12, 2, 0,
                              80 * 80 * 80 + 24 * 56 * 20},
                    RealModel{"pegs/objects_2mm_Line_cube_bottle.obj", LengthUnit::kMetre, 16, 24, 11, 1, 8,
                              80 * 80 * 80 - 26 * 58 * 25},
                    RealModel{"pegs/objects_2mm_Hexagon_cube_cap.obj", LengthUnit::kMetre, 20, 30, 14, 2, 0,
                              80 * 80 * 80 + 96 * Rational(27713, 1000) * 20},
                    RealModel{"pegs/objects_2mm_Hexagon_cube_bottle.obj", LengthUnit::kMetre, 20, 30, 13, 1,
                              12, 80 * 80 * 80 - 99 * Rational(28713, 1000) * 25}));

}  // namespace
}  // namespace tact::cad
