#include "robot/cad/mesh.h"

#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "algebra/error.h"
#include "robot/cad/cgal_soup.h"
#include "robot/cad/mesh_screen.h"
#include "robot/cad/planar_faces.h"
#include "robot/cad/step_file.h"

namespace tact::cad {
namespace {

using algebra::PolygonSoup;
using algebra::Polyhedron;
using algebra::Rational;

ScreenedMesh Screen(std::string_view contents, MeshFormat format, const std::string& name) {
  switch (format) {
    case MeshFormat::kOff:
      return ScreenOff(contents, name);
    case MeshFormat::kObj:
      return ScreenObj(contents, name);
    case MeshFormat::kStl:
      return ScreenStl(contents, name);
    case MeshFormat::kPly:
      return ScreenPly(contents, name);
    case MeshFormat::kStep:
      break;
  }
  throw PreconditionError("an unknown mesh format");
}

Rational ExactCoordinate(double value, bool single_precision) {
  if (!single_precision) return Rational::FromShortestDecimal(value);
  char text[64];
  const auto end = std::to_chars(text, text + sizeof text, static_cast<float>(value)).ptr;
  return *Rational::Parse(std::string_view(text, static_cast<size_t>(end - text)));
}

// The reader is lenient: what it returns must be what the screen saw.
void CheckSoup(const DoubleSoup& soup, const ScreenedMesh& screened, const std::string& name) {
  bool same = soup.polygons.size() == screened.corners.size() &&
              (!screened.shares_points || soup.points.size() == screened.points);
  for (size_t i = 0; same && i < soup.polygons.size(); ++i) {
    same = soup.polygons[i].size() == screened.corners[i];
    for (const size_t corner : soup.polygons[i]) same = same && corner < soup.points.size();
  }
  for (const auto& point : soup.points) {
    same = same && std::isfinite(point[0]) && std::isfinite(point[1]) && std::isfinite(point[2]);
  }
  if (same) return;
  throw InputError(name + ": expected " + std::to_string(screened.corners.size()) + " faces on " +
                   std::to_string(screened.points) + " finite vertices, got " +
                   std::to_string(soup.polygons.size()) + " faces on " + std::to_string(soup.points.size()) +
                   " vertices from the mesh reader");
}

PolygonSoup ExactSoup(const DoubleSoup& soup, bool single_precision) {
  PolygonSoup exact{{}, soup.polygons};
  exact.points.reserve(soup.points.size());
  for (const auto& [x, y, z] : soup.points) {
    exact.points.push_back({ExactCoordinate(x, single_precision), ExactCoordinate(y, single_precision),
                            ExactCoordinate(z, single_precision)});
  }
  return exact;
}

void Scale(const Rational& factor, Polyhedron* solid) {
  for (algebra::Vertex& vertex : solid->vertices) vertex.point = factor * vertex.point;
  for (algebra::Face& face : solid->faces) face.offset *= factor;
}

std::string PlaceOf(const algebra::SoupDefect& defect, const ScreenedMesh& screened,
                    const std::string& name) {
  if (defect.polygon == algebra::SoupDefect::kNone) return name + ": ";
  const std::string face = ": face " + std::to_string(defect.polygon + 1) + ": ";
  if (screened.polygon_lines.empty()) return name + face;
  return name + ":" + std::to_string(screened.polygon_lines[defect.polygon]) + face;
}

Mesh ReadStep(std::string_view contents, const std::string& name, LengthUnit target) {
  const std::vector<LoopedFace> faces = ReadStepFaces(contents, name);
  const PlanarFaces planar = MakePlanar(faces, name);
  try {
    Mesh mesh{algebra::BuildPolyhedron(planar.soup), planar.notes};
    Scale(Ratio(LengthUnit::kMillimetre, target), &mesh.solid);
    return mesh;
  } catch (const algebra::SoupError& error) {
    const size_t polygon = error.defect().polygon;
    throw InputError(
        name + ": " +
        (polygon == algebra::SoupDefect::kNone ? "" : faces[planar.face_of_polygon[polygon]].name + ": ") +
        error.defect().what);
  }
}

}  // namespace

MeshFormat MeshFormatOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  if (extension == ".off") return MeshFormat::kOff;
  if (extension == ".obj") return MeshFormat::kObj;
  if (extension == ".stl") return MeshFormat::kStl;
  if (extension == ".ply") return MeshFormat::kPly;
  if (extension == ".step" || extension == ".stp") return MeshFormat::kStep;
  throw InputError(path + ": expected a mesh file named .off, .obj, .stl, .ply, .step or .stp, got " +
                   (extension.empty() ? "no extension" : "\"" + extension + "\""));
}

Mesh ReadMesh(const std::string& path, LengthUnit unit, LengthUnit target) {
  const MeshFormat format = MeshFormatOf(path);
  if (std::filesystem::is_directory(path)) throw InputError(path + ": expected a file, got a folder");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream contents;
  if (!file) {
    throw InputError(path +
                     ": expected a readable file, got: " + (errno == 0 ? "no access" : std::strerror(errno)));
  }
  contents << file.rdbuf();
  return ReadMesh(std::move(contents).str(), format, path, unit, target);
}

Mesh ReadMesh(std::string_view contents, MeshFormat format, const std::string& name, LengthUnit unit,
              LengthUnit target) {
  if (contents.empty()) throw InputError(name + ": expected a mesh, got an empty file");
  if (format == MeshFormat::kStep) return ReadStep(contents, name, target);
  ScreenedMesh screened = Screen(contents, format, name);
  const auto soup = ReadSoup(screened.contents, format);
  if (!soup) throw InputError(name + ": expected a mesh, got contents that the mesh reader refuses");
  CheckSoup(*soup, screened, name);
  try {
    Mesh mesh{algebra::BuildPolyhedron(ExactSoup(*soup, screened.single_precision)), screened.notes};
    Scale(Ratio(unit, target), &mesh.solid);
    return mesh;
  } catch (const algebra::SoupError& error) {
    throw InputError(PlaceOf(error.defect(), screened, name) + error.defect().what);
  }
}

}  // namespace tact::cad
