#include "robot/joint/two_axis_search.h"

#include <queue>
#include <vector>

#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

constexpr int kMostTurns = 5000;
constexpr double kSettled = 1e-12;  // radian a turn

using Matrix9 = Eigen::Matrix<double, 9, 9>;

// The quadratic form in v of mean (u . R v)^2.
Eigen::Matrix3d FormInV(const Matrix9& moment, const Eigen::Vector3d& u) {
  Eigen::Matrix3d form;
  for (int b = 0; b < 3; ++b) {
    for (int d = b; d < 3; ++d) form(b, d) = form(d, b) = u.dot(moment.block<3, 3>(3 * b, 3 * d) * u);
  }
  return form;
}

// The quadratic form in u of mean (u . R v)^2.
Eigen::Matrix3d FormInU(const Matrix9& moment, const Eigen::Vector3d& v) {
  Eigen::Matrix3d form = Eigen::Matrix3d::Zero();
  for (int b = 0; b < 3; ++b) {
    for (int d = 0; d < 3; ++d) form += v[b] * v[d] * moment.block<3, 3>(3 * b, 3 * d);
  }
  return form;
}

double Root(double value) { return std::sqrt(std::max(0.0, value)); }

// A square of a face of the cube: face 0, 1, 2 is x, y, z = 1.
struct Cell {
  int face;
  double s, t, half;
  double bound;  // no u within has a smaller g

  Eigen::Vector3d Point(double ds, double dt) const {
    Eigen::Vector3d point;
    point[face] = 1;
    point[(face + 1) % 3] = s + ds;
    point[(face + 2) % 3] = t + dt;
    return point.normalized();
  }
  // The farthest from the centre is a corner.
  double Radius(const Eigen::Vector3d& center) const {
    double radius = 0;
    for (const double ds : {-half, half}) {
      for (const double dt : {-half, half}) radius = std::max(radius, (Point(ds, dt) - center).norm());
    }
    return radius;
  }
};
bool operator<(const Cell& a, const Cell& b) { return a.bound > b.bound; }

TwoAxes Polished(const Matrix9& moment, const Eigen::Vector3d& u_B) {
  TwoAxes best{u_B, Eigen::Vector3d::UnitY(), 2, 0};
  for (int turn = 0; turn < kMostTurns; ++turn) {
    best.v_A = EigenOf(FormInV(moment, best.u_B)).vectors.col(0);
    const SymmetricEigen3 in_u = EigenOf(FormInU(moment, best.v_A));
    const double change = in_u.vectors.col(0).cross(best.u_B).norm();
    best.u_B = in_u.vectors.col(0);
    best.rms = Root(in_u.values[0]);
    if (change < kSettled) break;
  }
  return best;
}

}  // namespace

TwoAxes PolishTwoAxes(const OrientationMoment& orientations, const Eigen::Vector3d& u_B) {
  return Polished(orientations.Mean(), u_B);
}

TwoAxes FindTwoAxes(const OrientationMoment& orientations) {
  const Matrix9 moment = orientations.Mean();
  TwoAxes best{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), 2, 0};
  std::priority_queue<Cell> cells;
  const auto visit = [&](Cell cell, double least) {
    const Eigen::Vector3d center = cell.Point(0, 0);
    const double g = Root(EigenOf(FormInV(moment, center)).values[0]);
    ++best.evaluations;
    if (g < best.rms) {
      best.rms = g;
      best.u_B = center;
    }
    cell.bound = std::max(least, g - cell.Radius(center));
    cells.push(cell);
  };
  for (int face = 0; face < 3; ++face) visit({face, 0, 0, 1, 0}, 0);
  while (!cells.empty() && cells.top().bound < best.rms - kSearchGap) {
    const Cell cell = cells.top();
    cells.pop();
    for (const double ds : {-cell.half / 2, cell.half / 2}) {
      for (const double dt : {-cell.half / 2, cell.half / 2}) {
        visit({cell.face, cell.s + ds, cell.t + dt, cell.half / 2, 0}, cell.bound);
      }
    }
  }
  const int evaluations = best.evaluations;
  best = Polished(moment, best.u_B);
  best.evaluations = evaluations;
  return best;
}

TwoAxes FindTwoAxes(std::span<const Transform> poses) {
  OrientationMoment moment;
  for (const Transform& X_BA : poses) moment.Add(X_BA.R);
  return FindTwoAxes(moment);
}

}  // namespace tact::joint
