#include "enumerators/lattice_solid.h"

#include <map>
#include <set>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

using Corner = std::array<int, 3>;

std::set<Corner> CubesOf(const std::vector<LatticeBox>& boxes) {
  std::set<Corner> cubes;
  for (const LatticeBox& box : boxes) {
    for (int x = box.from[0]; x < box.to[0]; ++x) {
      for (int y = box.from[1]; y < box.to[1]; ++y) {
        for (int z = box.from[2]; z < box.to[2]; ++z) cubes.insert({x, y, z});
      }
    }
  }
  return cubes;
}

class Surface {
 public:
  void Add(const std::array<Corner, 4>& square) {
    auto& polygon = soup_.polygons.emplace_back();
    for (const Corner& corner : square) {
      const auto [at, is_new] = index_.emplace(corner, soup_.points.size());
      if (is_new) soup_.points.push_back({corner[0], corner[1], corner[2]});
      polygon.push_back(at->second);
    }
  }
  const algebra::PolygonSoup& soup() const { return soup_; }

 private:
  algebra::PolygonSoup soup_;
  std::map<Corner, size_t> index_;
};

}  // namespace

algebra::Polyhedron LatticeSolid(const std::vector<LatticeBox>& filled,
                                 const std::vector<LatticeBox>& carved) {
  std::set<Corner> cubes = CubesOf(filled);
  for (const Corner& cube : CubesOf(carved)) cubes.erase(cube);
  if (cubes.empty()) throw PreconditionError("a lattice solid without cubes");
  Surface surface;
  for (const Corner& cube : cubes) {
    for (size_t axis = 0; axis < 3; ++axis) {
      for (const int side : {-1, 1}) {
        Corner neighbour = cube;
        neighbour[axis] += side;
        if (cubes.count(neighbour) != 0) continue;
        Corner a = cube;
        if (side > 0) ++a[axis];
        Corner b = a, c = a, d = a;
        const size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        ++b[u], ++c[u], ++c[v], ++d[v];
        if (side > 0) {
          surface.Add({a, b, c, d});
        } else {
          surface.Add({a, d, c, b});
        }
      }
    }
  }
  return BuildPolyhedron(surface.soup());
}

}  // namespace tact::enumerators
