#include "robot/cad/face_cut.h"

#include <algorithm>

#include "algebra/solid/planar_region.h"

namespace tact::cad {
namespace {

using algebra::Axes;
using algebra::Vector3;
using Loop = std::vector<size_t>;

class FaceCutter {
 public:
  FaceCutter(const std::vector<Vector3>& points, const Vector3& normal)
      : points_(points), axes_(algebra::ProjectionAxes(normal)) {}

  std::optional<std::vector<std::array<size_t, 3>>> Cut(std::vector<Loop> loops) const {
    Loop outer = std::move(loops.front());
    loops.erase(loops.begin());
    while (!loops.empty()) {
      if (!BridgeOne(&outer, &loops)) return std::nullopt;
    }
    return CutEars(std::move(outer));
  }

 private:
  int Turn(size_t a, size_t b, size_t c) const {
    return algebra::Orientation(axes_, points_[a], points_[b], points_[c]);
  }
  bool Same(size_t a, size_t b) const { return points_[a] == points_[b]; }

  // Whether the segment meets an edge of the loop at more than an end of both.
  bool Crosses(size_t a, size_t b, const Loop& loop) const {
    for (size_t i = 0; i < loop.size(); ++i) {
      const size_t c = loop[i], d = loop[(i + 1) % loop.size()];
      if (algebra::UnsharedPoint(axes_, points_[a], points_[b], points_[c], points_[d])) return true;
    }
    return false;
  }

  // Whether the direction from loop[i] to a point leads into the region, which lies on the loop's left.
  bool LeadsIn(const Loop& loop, size_t i, size_t to) const {
    const size_t before = loop[(i + loop.size() - 1) % loop.size()], at = loop[i],
                 after = loop[(i + 1) % loop.size()];
    const bool left_of_out = Turn(at, after, to) > 0, right_of_in = Turn(before, at, to) > 0;
    return Turn(before, at, after) > 0 ? left_of_out && right_of_in : left_of_out || right_of_in;
  }

  // Joins some hole to the outer loop by a segment that meets nothing else.
  bool BridgeOne(Loop* outer, std::vector<Loop>* holes) const {
    for (size_t h = 0; h < holes->size(); ++h) {
      const Loop& hole = (*holes)[h];
      for (size_t i = 0; i < outer->size(); ++i) {
        for (size_t k = 0; k < hole.size(); ++k) {
          const size_t from = (*outer)[i], to = hole[k];
          if (Same(from, to) || !LeadsIn(*outer, i, to) || !LeadsIn(hole, k, from) ||
              Crosses(from, to, *outer))
            continue;
          const bool free = std::none_of(holes->begin(), holes->end(),
                                         [&](const Loop& other) { return Crosses(from, to, other); });
          if (!free) continue;
          Loop joined(outer->begin(), outer->begin() + static_cast<std::ptrdiff_t>(i) + 1);
          for (size_t step = 0; step <= hole.size(); ++step) joined.push_back(hole[(k + step) % hole.size()]);
          joined.insert(joined.end(), outer->begin() + static_cast<std::ptrdiff_t>(i), outer->end());
          *outer = std::move(joined);
          holes->erase(holes->begin() + static_cast<std::ptrdiff_t>(h));
          return true;
        }
      }
    }
    return false;
  }

  // Whether a corner keeps the triangle from being an ear: it lies in it or on its rim, its corners apart.
  bool Blocks(size_t p, size_t a, size_t b, size_t c) const {
    if (Same(p, a) || Same(p, b) || Same(p, c)) return false;
    return Turn(a, b, p) >= 0 && Turn(b, c, p) >= 0 && Turn(c, a, p) >= 0;
  }

  bool IsEar(const Loop& loop, size_t i) const {
    const size_t n = loop.size(), a = loop[(i + n - 1) % n], b = loop[i], c = loop[(i + 1) % n];
    if (Turn(a, b, c) <= 0) return false;
    return std::none_of(loop.begin(), loop.end(), [&](size_t p) { return Blocks(p, a, b, c); });
  }

  std::optional<std::vector<std::array<size_t, 3>>> CutEars(Loop loop) const {
    std::vector<std::array<size_t, 3>> triangles;
    while (loop.size() > 2) {
      size_t i = 0;
      while (i < loop.size() && !IsEar(loop, i)) ++i;
      if (i == loop.size()) return std::nullopt;
      const size_t n = loop.size();
      triangles.push_back({loop[(i + n - 1) % n], loop[i], loop[(i + 1) % n]});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(i));
    }
    return triangles;
  }

  const std::vector<Vector3>& points_;
  Axes axes_;
};

}  // namespace

std::optional<std::vector<std::array<size_t, 3>>> CutFace(const std::vector<Vector3>& points,
                                                          const std::vector<std::vector<size_t>>& loops,
                                                          const Vector3& normal) {
  return FaceCutter(points, normal).Cut(loops);
}

}  // namespace tact::cad
