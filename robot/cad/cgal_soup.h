/// @file
/// CGAL's readers of polygon soups behind our own types; the only file that includes CGAL is cgal_soup.cc.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "robot/cad/mesh.h"

namespace tact::cad {

struct DoubleSoup {
  std::vector<std::array<double, 3>> points;
  std::vector<std::vector<size_t>> polygons;
};

/// nullopt if CGAL refuses the contents; it does not say why.
std::optional<DoubleSoup> ReadSoup(const std::string& contents, MeshFormat format);

}  // namespace tact::cad
