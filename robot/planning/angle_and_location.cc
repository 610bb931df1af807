#include "robot/planning/angle_and_location.h"

#include <algorithm>
#include <cmath>

namespace tact::planning {
namespace {

using Eigen::Vector3d;

// The sine between a normal and the span of others below which it counts as in it: its gap then follows from theirs,
// or there is no solution.
constexpr double kInSpan = 1e-7;

struct Row {
  Vector3d normal, rest;  // rest: outside the span of the rows chosen
  double gap = 0;         // at the location reached so far
};

}  // namespace

Location NearestLocation(const Relation& relation, const recognition::SolidF& moving,
                         const recognition::SolidF& fixed, const Eigen::Matrix3d& R_FM,
                         const Eigen::Vector3d& from) {
  static thread_local std::vector<Row> rows;  // kept from call to call: a trajectory makes many
  rows.clear();
  for (const auto& contact : relation) {
    const recognition::Gap gap = GapOf(contact, moving, fixed, {R_FM, from});
    const Vector3d n = gap.row.tail<3>();
    rows.push_back({n, n, gap.gap});
  }
  Location location{from, 0};
  for (int rank = 0; rank < 3 && !rows.empty(); ++rank) {
    const auto best = std::max_element(rows.begin(), rows.end(), [](const Row& a, const Row& b) {
      return a.rest.squaredNorm() < b.rest.squaredNorm();
    });
    const double length = best->rest.norm();
    if (length < kInSpan) break;
    const Vector3d q = best->rest / length, step = -(best->gap / length) * q;
    location.p += step;
    for (Row& row : rows) {
      row.gap += row.normal.dot(step);
      row.rest -= q.dot(row.rest) * q;
    }
  }
  for (const Row& row : rows) location.violation = std::max(location.violation, std::abs(row.gap));
  return location;
}

double ViolationOf(const Relation& relation, const recognition::SolidF& moving,
                   const recognition::SolidF& fixed, const joint::Transform& X_FM) {
  double violation = 0;
  for (const auto& contact : relation)
    violation = std::max(violation, std::abs(GapOf(contact, moving, fixed, X_FM).gap));
  return violation;
}

}  // namespace tact::planning
