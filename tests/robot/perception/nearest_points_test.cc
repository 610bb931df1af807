#include "robot/perception/nearest_points.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace tact::perception {
namespace {

// Few coordinates, so that points coincide and distances tie.
std::vector<Eigen::Vector3d> SomePoints(int most) {
  std::vector<Eigen::Vector3d> points(static_cast<std::size_t>(*rc::gen::inRange(0, most)));
  for (auto& p : points)
    p = {double(*rc::gen::inRange(-6, 6)), double(*rc::gen::inRange(-6, 6)),
         double(*rc::gen::inRange(-2, 2))};
  return points;
}

std::vector<NearPoint> InOrder(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& place) {
  std::vector<NearPoint> all;
  for (std::uint32_t i = 0; i < points.size(); ++i) all.push_back({(points[i] - place).squaredNorm(), i});
  std::sort(all.begin(), all.end());
  return all;
}

RC_GTEST_PROP(NearestPoints, AreThoseThatSortingFinds, ()) {
  const auto points = SomePoints(150);
  const NearestPoints tree(points);
  const auto places = SomePoints(5);
  for (const auto& place : places) {
    std::vector<NearPoint> all = InOrder(points, place);
    const double reach = *rc::gen::inRange(0, 8);
    const auto nearest = tree.Nearest(place, reach);
    const bool expected = !all.empty() && all[0].squared_distance <= reach * reach;
    RC_ASSERT(nearest.has_value() == expected);
    if (nearest) RC_ASSERT(*nearest == all[0]);
    const auto count = static_cast<std::size_t>(*rc::gen::inRange(0, 20));
    if (all.size() > count) all.resize(count);
    RC_ASSERT(tree.Nearest(place, count) == all);
  }
}

}  // namespace
}  // namespace tact::perception
