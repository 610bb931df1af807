#include "provers/report/part_drawing.h"

#include <array>

#include "provers/report/svg_canvas.h"
#include "robot/joint/small_matrix.h"

namespace tact::provers {
namespace {

using Eigen::Vector3d;

// Columns: to the right along the points' longest direction, up, toward the viewer.
Eigen::Matrix3d ViewOf(std::span<const Vector3d> points) {
  Vector3d middle = Vector3d::Zero();
  for (const Vector3d& p : points) middle += p / static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3d& p : points) spread += (p - middle) * (p - middle).transpose();
  const Eigen::Matrix3d axes = joint::EigenOf(spread).vectors;
  Vector3d face = axes.col(0), right = axes.col(2);
  if (face.dot(middle) > 0) face = -face;
  if (right.x() < 0) right = -right;
  const Vector3d up = face.cross(right);
  constexpr double kCosine = 0.8, kSine = 0.6;  // of the view's slant
  Eigen::Matrix3d view;
  view << right, kCosine * up + kSine * face, kCosine * face - kSine * up;
  return view;
}

}  // namespace

std::string DrawParts(std::span<const Vector3d> points, std::span<const perception::Part> parts,
                      const perception::PartAxis* axis, std::size_t dots) {
  const Eigen::Matrix3d view = ViewOf(points);
  const auto seen = [&](const Vector3d& p) {
    const Vector3d v = view.transpose() * p;
    return ViewPoint{v.x(), v.y(), v.z()};
  };
  std::array<std::vector<std::pair<ViewPoint, ViewPoint>>, 3> marks;
  std::vector<ViewPoint> all;
  for (const std::uint32_t i : perception::EvenlySpread(points.size(), dots)) {
    all.push_back(seen(points[i]));
    marks[static_cast<std::size_t>(parts[i])].emplace_back(all.back(), all.back());
  }
  const double reach = 0.3 * Extent(all);
  std::vector<std::pair<ViewPoint, ViewPoint>> line;
  if (axis) {
    line = {{seen(axis->point - reach * axis->direction), seen(axis->point + reach * axis->direction)}};
    all.insert(all.end(), {line[0].first, line[0].second});
  }
  SvgCanvas canvas(all, 560, 420, false);
  constexpr std::array kColours = {"#2a62b0", "#c2452d", "#a8a8a8"};
  for (std::size_t part = 0; part < marks.size(); ++part)
    canvas.Lines(marks[part], std::string("stroke-width=\"2\" stroke=\"") + kColours[part] + "\"");
  canvas.Lines(line, "stroke-width=\"2.2\" stroke=\"#111111\"");
  return canvas.Finish("A scan divided into two parts" +
                       std::string(axis ? ", and the axis about which they turn" : ""));
}

}  // namespace tact::provers
