#include "robot/perception/plier.h"

#include <array>
#include <cmath>

#include "robot/perception/random_numbers.h"

namespace tact::perception {
namespace {

constexpr double kMillimetre = 1e-3;
constexpr std::size_t kSides = 16;  // of a section
constexpr int kSteps = 5;           // between two stations

// The bar at a place along its line, in millimetres: where its middle is, half its width, from where to where in z.
using Station = Eigen::Matrix<double, 5, 1>;  // x, y, half width, low, high

// From the handle's end to the jaw's tip. In the middle the other lever takes the lower half.
const std::array<std::array<double, 5>, 11> kStations = {{{-97, 23, 3.5, -3.5, 3.5},
                                                          {-92, 23.5, 5.5, -5.5, 5.5},
                                                          {-72, 24, 6, -6, 6},
                                                          {-46, 19, 5.5, -5.5, 5.5},
                                                          {-24, 9, 5.5, -5.5, 5.5},
                                                          {-10, 3.5, 6, 0.2, 5.5},
                                                          {0, 0, 7, 0.2, 5.5},
                                                          {10, -3.5, 6, 0.2, 5.5},
                                                          {20, -5.5, 5, -5, 5},
                                                          {36, -5, 4.4, -4.2, 4.2},
                                                          {53, -2.8, 2.6, -3, 3}}};
constexpr double kBossRadius = 10, kBossLow = 0.2, kBossHigh = 5.5;
constexpr double kRivetRadius = 4.5, kRivetHeight = 2;

Station At(std::size_t i) { return Station(kStations[i].data()); }

// Catmull and Rom's curve from station i to the next.
Station Between(std::size_t i, double t) {
  const Station before = At(i == 0 ? 0 : i - 1), a = At(i), b = At(i + 1),
                after = At(std::min(i + 2, kStations.size() - 1));
  return 0.5 * (2 * a + t * (b - before) + t * t * (2 * before - 5 * a + 4 * b - after) +
                t * t * t * (3 * (a - b) + after - before));
}

// Adds rings of kSides points, each joined to the next, closed by a point at either end.
class Tube {
 public:
  Tube(const Vector3d& start, TriangleMesh* mesh) : mesh_(mesh), tip_(Add(start)) {}
  template <typename PointAt>
  void Ring(const PointAt& point_at) {
    const std::size_t base = mesh_->points.size();
    for (std::size_t k = 0; k < kSides; ++k)
      Add(point_at(2 * M_PI * static_cast<double>(k) / static_cast<double>(kSides)));
    for (std::size_t k = 0; k < kSides; ++k) {
      const std::size_t next = (k + 1) % kSides;
      if (!open_) {
        mesh_->triangles.push_back({tip_, base + next, base + k});
      } else {
        mesh_->triangles.push_back({ring_ + k, ring_ + next, base + next});
        mesh_->triangles.push_back({ring_ + k, base + next, base + k});
      }
    }
    ring_ = base;
    open_ = true;
  }
  void Close(const Vector3d& end) {
    const std::size_t tip = Add(end);
    for (std::size_t k = 0; k < kSides; ++k)
      mesh_->triangles.push_back({ring_ + k, ring_ + (k + 1) % kSides, tip});
  }

 private:
  std::size_t Add(const Vector3d& millimetres) {
    mesh_->points.push_back(kMillimetre * millimetres);
    return mesh_->points.size() - 1;
  }
  TriangleMesh* mesh_;
  std::size_t tip_, ring_ = 0;
  bool open_ = false;
};

// Between an ellipse and a rectangle.
double Rounded(double cosine) { return std::copysign(std::pow(std::abs(cosine), 0.7), cosine); }

void AddBar(TriangleMesh* mesh) {
  std::vector<Station> line;
  for (std::size_t i = 0; i + 1 < kStations.size(); ++i) {
    for (int step = 0; step < kSteps; ++step) line.push_back(Between(i, static_cast<double>(step) / kSteps));
  }
  line.push_back(At(kStations.size() - 1));
  const auto middle = [](const Station& s) { return Vector3d(s[0], s[1], (s[3] + s[4]) / 2); };
  Tube tube(middle(line.front()) - Vector3d(2, 0, 0), mesh);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Station &s = line[i], &from = line[i == 0 ? 0 : i - 1],
                  &to = line[std::min(i + 1, line.size() - 1)];
    const Vector3d along = Vector3d(to[0] - from[0], to[1] - from[1], 0).normalized();
    const Vector3d across = Vector3d::UnitZ().cross(along);
    tube.Ring([&](double angle) {
      return Vector3d(middle(s) + across * (s[2] * Rounded(std::cos(angle))) +
                      Vector3d::UnitZ() * ((s[4] - s[3]) / 2 * Rounded(std::sin(angle))));
    });
  }
  tube.Close(middle(line.back()) + Vector3d(1, 0, 0));
}

// A body of revolution about z by the radii at heights, bottom to top.
void AddTurned(const std::vector<std::array<double, 2>>& profile, TriangleMesh* mesh) {
  Tube tube({0, 0, profile.front()[1]}, mesh);
  for (const auto& [radius, height] : profile) {
    const double r = radius, z = height;
    tube.Ring([r, z](double angle) { return Vector3d(r * std::cos(angle), r * std::sin(angle), z); });
  }
  tube.Close({0, 0, profile.back()[1]});
}

}  // namespace

TriangleMesh PlierLever() {
  TriangleMesh mesh;
  AddBar(&mesh);
  AddTurned({{kBossRadius, kBossLow}, {kBossRadius, kBossHigh - 1}, {kBossRadius - 1, kBossHigh}}, &mesh);
  AddTurned({{kRivetRadius, kBossHigh - 1},
             {kRivetRadius, kBossHigh + 0.2 * kRivetHeight},
             {0.8 * kRivetRadius, kBossHigh + 0.7 * kRivetHeight},
             {0.4 * kRivetRadius, kBossHigh + kRivetHeight}},
            &mesh);
  return mesh;
}

std::vector<PosedMesh> OpenPlier(const Transform& X_CL, double opening) {
  const Transform turned_over{Vector3d(1, -1, -1).asDiagonal(), Vector3d::Zero()};
  const Transform opened{joint::RotationExp({0, 0, opening}), Vector3d::Zero()};
  return {{PlierLever(), X_CL}, {PlierLever(), X_CL * opened * turned_over}};
}

std::vector<PlierScan> ScanPlier(const PlierStudy& study) {
  RandomNumbers random(study.seed);
  // The plier's upper side faces the camera, a little tilted, and is turned half as far as it opens.
  const Transform middle{joint::RotationExp({M_PI, 0, 0}) * joint::RotationExp({0.35, 0.25, 0}),
                         Vector3d(0.01, 0, 0.7)};
  std::vector<PlierScan> scans;
  for (const double opening : study.openings) {
    const Transform put{joint::RotationExp(study.turned * random.InBall()), study.shifted * random.InBall()};
    const Transform half{joint::RotationExp({0, 0, -opening / 2}), Vector3d::Zero()};
    const Transform X_CL = middle * put * half;
    scans.push_back({TakeRangeImage(study.camera, OpenPlier(X_CL, opening), study.seed * 1000 + scans.size()),
                     X_CL, opening});
  }
  return scans;
}

}  // namespace tact::perception
