#include "robot/cad/planar_faces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <optional>

#include "algebra/error.h"
#include "algebra/solid/planar_region.h"
#include "robot/cad/face_cut.h"

namespace tact::cad {
namespace {

using algebra::Rational;
using algebra::Vector3;
using Eigen::Vector3d;

constexpr long kPlaces = 1'000'000'000;  // of rounded coordinates, 1 / kCornerGrid, and of rounded normals
constexpr double kFarthest = 1e9;        // millimetre: times kPlaces it fits 64 bits
constexpr double kSameDirection = 1e-7;  // between unit normals of one plane that was computed twice
constexpr double kSameOffset = 1e-6;     // millimetre, likewise
constexpr double kPlanesMeet = 1e-6;     // volume spanned by unit normals: flatter ones meet nowhere near

struct Plane {
  Vector3 normal;
  Rational offset;
  Vector3d direction;  // of length one
  double distance = 0;

  bool Holds(const Vector3& p) const { return Dot(normal, p) == offset; }
};

Rational Rounded(double value) { return Rational(std::lround(value * kPlaces)) / Rational(kPlaces); }

Vector3d InDoubles(const Vector3& v) {
  return {algebra::ToDouble(v.x), algebra::ToDouble(v.y), algebra::ToDouble(v.z)};
}

Vector3d DoubleArea(const std::vector<Vector3d>& loop) {
  Vector3d sum = Vector3d::Zero();
  for (size_t i = 1; i + 1 < loop.size(); ++i) sum += (loop[i] - loop[0]).cross(loop[i + 1] - loop[0]);
  return sum;
}

std::string Text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

class PlanarMaker {
 public:
  PlanarMaker(const std::vector<LoopedFace>& faces, std::string name)
      : faces_(faces), name_(std::move(name)) {}

  PlanarFaces Make() {
    for (const LoopedFace& face : faces_) AddCorners(face);
    if (!FindPlanes()) MeetPlanes();
    PlanarFaces result;
    for (size_t f = 0; f < faces_.size(); ++f) AppendPolygons(f, &result);
    result.soup.points = std::move(points_);
    result.notes = std::move(notes_);
    return result;
  }

 private:
  [[noreturn]] void Refuse(size_t f, const std::string& message) const {
    throw InputError(name_ + ": " + faces_[f].name + ": " + message);
  }

  size_t CornerAt(const Vector3d& p, const LoopedFace& face) {
    if (!(p.cwiseAbs().maxCoeff() < kFarthest))
      throw InputError(name_ + ": " + face.name + ": expected corners within 1000 km, got one beyond");
    const std::array<long, 3> key = {std::lround(p.x() * kPlaces), std::lround(p.y() * kPlaces),
                                     std::lround(p.z() * kPlaces)};
    const auto [it, is_new] = corner_of_.emplace(key, points_.size());
    if (is_new) {
      points_.push_back({Rounded(p.x()), Rounded(p.y()), Rounded(p.z())});
      doubles_.push_back(p);
    }
    return it->second;
  }

  // Outer loops counter-clockwise about the outward normal, holes clockwise.
  void AddCorners(const LoopedFace& face) {
    std::vector<std::vector<size_t>> loops;
    for (const auto& loop : face.loops) {
      std::vector<size_t> corners;
      for (const Vector3d& p : loop) corners.push_back(CornerAt(p, face));
      const bool counter = DoubleArea(loop).dot(face.normal) > 0;
      if (counter != loops.empty()) std::reverse(corners.begin(), corners.end());
      loops.push_back(std::move(corners));
    }
    loops_.push_back(std::move(loops));
  }

  std::optional<Plane> ExactPlane(size_t f) const {
    std::vector<const Vector3*> outer;
    for (const size_t corner : loops_[f].front()) outer.push_back(&points_[corner]);
    Plane plane;
    plane.normal = algebra::DoubleArea(outer);
    if (plane.normal.IsZero()) Refuse(f, "expected a face with an area, got one without");
    plane.offset = Dot(plane.normal, *outer.front());
    for (const auto& loop : loops_[f]) {
      for (const size_t corner : loop) {
        if (!plane.Holds(points_[corner])) return std::nullopt;
      }
    }
    const Vector3d normal = InDoubles(plane.normal);
    plane.direction = normal.normalized();
    plane.distance = algebra::ToDouble(plane.offset) / normal.norm();
    return plane;
  }

  Plane RoundedPlane(size_t f) const {
    std::vector<Vector3d> outer;
    for (const size_t corner : loops_[f].front()) outer.push_back(doubles_[corner]);
    Plane plane;
    plane.direction = DoubleArea(outer).normalized();
    double sum = 0;
    for (const Vector3d& p : outer) sum += plane.direction.dot(p);
    plane.distance = sum / static_cast<double>(outer.size());
    for (const Plane& other : planes_) {
      if ((other.direction - plane.direction).norm() < kSameDirection &&
          std::abs(other.distance - plane.distance) < kSameOffset)
        return other;
    }
    plane.normal = {Rounded(plane.direction.x()), Rounded(plane.direction.y()), Rounded(plane.direction.z())};
    plane.offset = Rounded(plane.distance);
    return plane;
  }

  // Whether all faces are planar as they are; planes_[f] is face f's in any case.
  bool FindPlanes() {
    std::vector<std::optional<Plane>> exact;
    for (size_t f = 0; f < faces_.size(); ++f) {
      exact.push_back(ExactPlane(f));
      if (exact[f]) planes_.push_back(*exact[f]);
    }
    // Exact planes first, so that rounded ones may be found among them.
    std::vector<Plane> planes(faces_.size());
    for (size_t f = 0; f < faces_.size(); ++f) {
      if (exact[f]) {
        planes[f] = *exact[f];
      } else {
        planes[f] = RoundedPlane(f);
        planes_.push_back(planes[f]);
        ++askew_;
      }
    }
    planes_ = std::move(planes);
    return askew_ == 0;
  }

  // The planes at each corner, each once.
  std::vector<std::vector<size_t>> PlanesAtCorners() const {
    std::vector<std::vector<size_t>> at(points_.size());
    for (size_t f = 0; f < faces_.size(); ++f) {
      for (const auto& loop : loops_[f]) {
        for (const size_t corner : loop) {
          const bool known = std::any_of(at[corner].begin(), at[corner].end(), [&](size_t g) {
            return planes_[g].offset == planes_[f].offset && planes_[g].normal == planes_[f].normal;
          });
          if (!known) at[corner].push_back(f);
        }
      }
    }
    return at;
  }

  // Three planes that meet near p as squarely as they can: the given ones, completed where they are fewer.
  std::array<Plane, 3> ThreePlanes(const std::vector<size_t>& at, const Vector3& p) const {
    double best = kPlanesMeet;
    std::array<Plane, 3> three;
    for (size_t i = 0; i < at.size(); ++i) {
      for (size_t j = i + 1; j < at.size(); ++j) {
        for (size_t k = j + 1; k < at.size(); ++k) {
          const Plane &a = planes_[at[i]], &b = planes_[at[j]], &c = planes_[at[k]];
          const double volume = std::abs(a.direction.cross(b.direction).dot(c.direction));
          if (volume > best) best = volume, three = {a, b, c};
        }
      }
    }
    if (best > kPlanesMeet) return three;
    const auto through = [&p](const Vector3& normal) {
      Plane plane;
      plane.normal = normal;
      plane.offset = Dot(normal, p);
      return plane;
    };
    const Plane& a = planes_[at[0]];
    size_t other = 0;
    for (size_t j = 1; j < at.size(); ++j) {
      const double sine = a.direction.cross(planes_[at[j]].direction).norm();
      if (sine > best) best = sine, other = j;
    }
    if (other > 0) {
      const Plane& b = planes_[at[other]];
      return {a, b, through(Cross(a.normal, b.normal))};
    }
    int axis = 0;
    a.direction.cwiseAbs().minCoeff(&axis);
    Vector3 along;
    along[axis] = 1;
    const Vector3 across = Cross(a.normal, along);
    return {a, through(across), through(Cross(a.normal, across))};
  }

  // Moves every corner of a rounded plane to where its planes meet.
  void MeetPlanes() {
    const auto at = PlanesAtCorners();
    double widest = 0;
    for (size_t corner = 0; corner < points_.size(); ++corner) {
      const Vector3 p = points_[corner];
      if (std::all_of(at[corner].begin(), at[corner].end(), [&](size_t f) { return planes_[f].Holds(p); }))
        continue;
      const auto [a, b, c] = ThreePlanes(at[corner], p);
      const Vector3 bc = Cross(b.normal, c.normal), ca = Cross(c.normal, a.normal),
                    ab = Cross(a.normal, b.normal);
      const Vector3 met = (Rational(1) / Dot(a.normal, bc)) * (a.offset * bc + b.offset * ca + c.offset * ab);
      const double move = (InDoubles(met) - doubles_[corner]).norm();
      for (const size_t f : at[corner]) {
        if (move > kMostCornerMove)
          Refuse(f, "expected a planar face, got one whose corners are " + Text(move) + " mm off its plane");
        if (!planes_[f].Holds(met)) {
          Refuse(f, "expected a face that is planar in exact numbers, got a corner at (" +
                        Text(doubles_[corner].x()) + ", " + Text(doubles_[corner].y()) + ", " +
                        Text(doubles_[corner].z()) + ") where " + std::to_string(at[corner].size()) +
                        " planes meet askew; export the model aligned with its axes, or as STL");
        }
      }
      widest = std::max(widest, move);
      points_[corner] = met;
    }
    notes_.push_back(name_ + ": " + std::to_string(askew_) + " of " + std::to_string(faces_.size()) +
                     " faces have no planar short decimals; corners were moved by up to " + Text(widest) +
                     " mm to where rounded planes meet");
  }

  void AppendPolygons(size_t f, PlanarFaces* result) const {
    if (loops_[f].size() == 1) {
      result->soup.polygons.push_back(loops_[f].front());
      result->face_of_polygon.push_back(f);
      return;
    }
    const auto triangles = CutFace(points_, loops_[f], planes_[f].normal);
    if (!triangles)
      Refuse(f, "expected holes inside the face that meet neither its rim nor each other, got others");
    for (const auto& triangle : *triangles) {
      result->soup.polygons.emplace_back(triangle.begin(), triangle.end());
      result->face_of_polygon.push_back(f);
    }
  }

  const std::vector<LoopedFace>& faces_;
  std::string name_;
  std::map<std::array<long, 3>, size_t> corner_of_;
  std::vector<Vector3> points_;
  std::vector<Vector3d> doubles_;
  std::vector<std::vector<std::vector<size_t>>> loops_;  // of each face
  std::vector<Plane> planes_;                            // of each face
  size_t askew_ = 0;
  std::vector<std::string> notes_;
};

}  // namespace

PlanarFaces MakePlanar(const std::vector<LoopedFace>& faces, const std::string& name) {
  return PlanarMaker(faces, name).Make();
}

}  // namespace tact::cad
