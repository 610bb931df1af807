#include "robot/cad/cgal_soup.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <exception>
#include <sstream>

namespace tact::cad {
namespace {

using Point = CGAL::Simple_cartesian<double>::Point_3;

bool Read(std::istream& stream, MeshFormat format, std::vector<Point>& points,
          std::vector<std::vector<size_t>>& polygons) {
  const auto quiet = CGAL::parameters::verbose(false);
  switch (format) {
    case MeshFormat::kOff:
      return CGAL::IO::read_OFF(stream, points, polygons, quiet);
    case MeshFormat::kObj:
      return CGAL::IO::read_OBJ(stream, points, polygons, quiet);
    case MeshFormat::kStl:
      return CGAL::IO::read_STL(stream, points, polygons, quiet);
    case MeshFormat::kPly:
      return CGAL::IO::read_PLY(stream, points, polygons, quiet);
    case MeshFormat::kStep:
      break;
  }
  return false;
}

}  // namespace

std::optional<DoubleSoup> ReadSoup(const std::string& contents, MeshFormat format) {
  std::istringstream stream(contents);
  std::vector<Point> points;
  DoubleSoup soup;
  if (!Read(stream, format, points, soup.polygons)) return std::nullopt;
  for (const Point& p : points) soup.points.push_back({p.x(), p.y(), p.z()});
  return soup;
}

}  // namespace tact::cad
