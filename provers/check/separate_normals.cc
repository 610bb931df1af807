#include "provers/check/separate_normals.h"

#include <algorithm>

namespace tact::check {

bool SameDirection(const Row& a, const Row& b) { return Cross(a, b) == Row(3) && Dot(a, b) > 0; }

bool Includes(const Matrix& larger, const Matrix& smaller) {
  return std::all_of(smaller.begin(), smaller.end(), [&](const Row& n) {
    return std::any_of(larger.begin(), larger.end(), [&](const Row& m) { return SameDirection(m, n); });
  });
}

Matrix ExtremeNormals(const Matrix& generators) {
  Matrix normals;
  const auto try_normal = [&](const Row& n) {
    const bool separates =
        std::all_of(generators.begin(), generators.end(), [&](const Row& g) { return Dot(n, g) >= 0; });
    if (separates && !Includes(normals, {n})) normals.push_back(n);
  };
  for (std::size_t i = 0; i < generators.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Row n = Cross(generators[i], generators[j]);
      if (n == Row(3)) continue;
      try_normal(n);
      try_normal({-n[0], -n[1], -n[2]});
    }
  }
  return normals;
}

Matrix SeparateNormals(const Piece& moving, const Piece& fixed, const Row& point) {
  Matrix generators;
  for (const Row& m : moving) generators.push_back(Difference(m, point));
  for (const Row& f : fixed) generators.push_back(Difference(point, f));
  return ExtremeNormals(generators);
}

}  // namespace tact::check
