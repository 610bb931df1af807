#include "robot/correction/convex_pieces.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace tact::correction {
namespace {

using Eigen::Vector3d;
using Loop = std::vector<Vector3d>;

// A face, or what of it lies in a cell: the outer loop and its holes; clipped loops may run along the cut to and fro.
struct Fragment {
  HalfSpace plane;
  std::vector<Loop> loops;
};

double Area(const Fragment& fragment) {
  Vector3d twice = Vector3d::Zero();
  for (const Loop& loop : fragment.loops)
    for (size_t i = 0; i < loop.size(); ++i) twice += loop[i].cross(loop[(i + 1) % loop.size()]);
  return std::abs(twice.dot(fragment.plane.normal)) / 2;
}

// What lies in the half-space [Sutherland and Hodgman 1974].
Loop Clip(const Loop& loop, const HalfSpace& keep) {
  Loop kept;
  for (size_t i = 0; i < loop.size(); ++i) {
    const Vector3d &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const double at_a = keep.normal.dot(a) - keep.offset, at_b = keep.normal.dot(b) - keep.offset;
    if (at_a <= 0) kept.push_back(a);
    if ((at_a < 0 && at_b > 0) || (at_a > 0 && at_b < 0))
      kept.emplace_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
  return kept;
}

Fragment Clip(const Fragment& fragment, const HalfSpace& keep) {
  Fragment kept{fragment.plane, {}};
  for (const Loop& loop : fragment.loops) {
    Loop part = Clip(loop, keep);
    if (part.size() > 2) kept.loops.push_back(std::move(part));
  }
  return kept;
}

HalfSpace Opposite(const HalfSpace& h) { return {-h.normal, -h.offset}; }

class Partition {
 public:
  Partition(const algebra::Polyhedron& solid, double size)
      : solid_(solid), thin_(kThin * size), size_(size) {}

  void Divide(const std::vector<Fragment>& fragments, std::vector<HalfSpace>& cell) {
    if (fragments.empty()) {
      Keep(cell);
      return;
    }
    const HalfSpace plane = fragments[Best(fragments)].plane;
    for (const HalfSpace& side : {plane, Opposite(plane)}) {
      std::vector<Fragment> inside;
      for (const Fragment& fragment : fragments) {
        if (Coplanar(fragment, plane)) continue;
        Fragment part = Clip(fragment, side);
        if (Area(part) > thin_ * size_) inside.push_back(std::move(part));
      }
      cell.push_back(side);
      Divide(inside, cell);
      cell.pop_back();
    }
  }
  std::vector<ConvexPiece> pieces;

 private:
  bool Coplanar(const Fragment& fragment, const HalfSpace& plane) const {
    for (const Loop& loop : fragment.loops)
      for (const Vector3d& p : loop)
        if (std::abs(plane.normal.dot(p) - plane.offset) > thin_) return false;
    return true;
  }
  // The plane that cuts the fewest others; of these, one with all others behind.
  size_t Best(const std::vector<Fragment>& fragments) const {
    size_t best = 0, least = static_cast<size_t>(-1);
    for (size_t i = 0; i < fragments.size(); ++i) {
      size_t cost = 0;
      for (const Fragment& other : fragments) {
        double low = 0, high = 0;
        for (const Loop& loop : other.loops) {
          for (const Vector3d& p : loop) {
            const double at = fragments[i].plane.normal.dot(p) - fragments[i].plane.offset;
            low = std::min(low, at), high = std::max(high, at);
          }
        }
        cost += (high > thin_ ? 1 : 0) + (high > thin_ && low < -thin_ ? 100 : 0);
      }
      if (cost < least) least = cost, best = i;
    }
    return best;
  }
  void Keep(const std::vector<HalfSpace>& cell);

  const algebra::Polyhedron& solid_;
  double thin_, size_;
};

std::vector<Vector3d> CornersOf(const std::vector<HalfSpace>& cell, double thin) {
  std::vector<Vector3d> corners;
  for (size_t i = 0; i < cell.size(); ++i) {
    for (size_t j = i + 1; j < cell.size(); ++j) {
      for (size_t k = j + 1; k < cell.size(); ++k) {
        Eigen::Matrix3d normals;
        normals << cell[i].normal.transpose(), cell[j].normal.transpose(), cell[k].normal.transpose();
        if (std::abs(normals.determinant()) < kThin) continue;
        const Vector3d p = normals.inverse() * Vector3d(cell[i].offset, cell[j].offset, cell[k].offset);
        const bool in = std::all_of(cell.begin(), cell.end(),
                                    [&](const HalfSpace& h) { return h.normal.dot(p) - h.offset <= thin; });
        const bool is_new = std::none_of(corners.begin(), corners.end(),
                                         [&](const Vector3d& c) { return (c - p).norm() <= 10 * thin; });
        if (in && is_new) corners.push_back(p);
      }
    }
  }
  return corners;
}

void Partition::Keep(const std::vector<HalfSpace>& cell) {
  ConvexPiece piece;
  piece.vertices = CornersOf(cell, 10 * thin_);
  if (piece.vertices.size() < 4) return;
  piece.middle = Vector3d::Zero();
  for (const Vector3d& v : piece.vertices) piece.middle += v / static_cast<double>(piece.vertices.size());
  const algebra::Vector3 middle{algebra::Rational::FromShortestDecimal(piece.middle.x()),
                                algebra::Rational::FromShortestDecimal(piece.middle.y()),
                                algebra::Rational::FromShortestDecimal(piece.middle.z())};
  if (Locate(solid_, middle) != algebra::Side::kInside) return;
  std::vector<std::vector<char>> on;
  for (const HalfSpace& h : cell) {
    std::vector<char> at;
    for (const Vector3d& v : piece.vertices)
      at.push_back(std::abs(h.normal.dot(v) - h.offset) <= 100 * thin_ ? 1 : 0);
    if (std::count(at.begin(), at.end(), 1) < 3) continue;
    piece.faces.push_back(h);
    on.push_back(std::move(at));
  }
  for (size_t a = 0; a < piece.vertices.size(); ++a) {
    piece.radius = std::max(piece.radius, (piece.vertices[a] - piece.middle).norm());
    for (size_t b = a + 1; b < piece.vertices.size(); ++b) {
      int shared = 0;
      for (const auto& at : on) shared += at[a] & at[b];
      if (shared < 2) continue;
      const Vector3d direction = (piece.vertices[b] - piece.vertices[a]).normalized();
      piece.edges.push_back({a, b, direction});
      if (std::none_of(piece.directions.begin(), piece.directions.end(),
                       [&](const Vector3d& d) { return d.cross(direction).norm() < kThin; }))
        piece.directions.push_back(direction);
    }
  }
  pieces.push_back(std::move(piece));
}

Vector3d Double(const algebra::Vector3& v) { return {ToDouble(v.x), ToDouble(v.y), ToDouble(v.z)}; }

}  // namespace

std::vector<ConvexPiece> ConvexPiecesOf(const algebra::Polyhedron& solid) {
  std::vector<Fragment> fragments;
  Vector3d low = Vector3d::Constant(HUGE_VAL), high = -low;
  for (const auto& v : solid.vertices) {
    low = low.cwiseMin(Double(v.point));
    high = high.cwiseMax(Double(v.point));
  }
  for (const auto& face : solid.faces) {
    const Vector3d normal = Double(face.normal);
    Fragment fragment{{normal / normal.norm(), ToDouble(face.offset) / normal.norm()}, {}};
    for (const auto& loop : face.loops) {
      fragment.loops.emplace_back();
      for (const size_t v : loop) fragment.loops.back().push_back(Double(solid.vertices[v].point));
    }
    fragments.push_back(std::move(fragment));
  }
  Partition partition(solid, (high - low).maxCoeff());
  std::vector<HalfSpace> cell;
  partition.Divide(fragments, cell);
  return std::move(partition.pieces);
}

std::vector<HalfSpace> SidesOf(const ConvexPiece& piece, size_t face) {
  const HalfSpace& base = piece.faces[face];
  std::vector<HalfSpace> sides;
  for (size_t i = 0; i < piece.faces.size(); ++i) {
    const double cosine = piece.faces[i].normal.dot(base.normal);
    const Vector3d across = piece.faces[i].normal - cosine * base.normal;
    if (across.norm() < kThin) continue;
    sides.push_back({across / across.norm(), (piece.faces[i].offset - cosine * base.offset) / across.norm()});
  }
  return sides;
}

}  // namespace tact::correction
