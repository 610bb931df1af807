#include "provers/report/joint_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "provers/report/svg_canvas.h"

namespace tact::provers {
namespace {

using Eigen::Vector3d;
using joint::JointType;
using joint::Link;
using joint::NamedParameter;
using joint::ParameterKind;

constexpr size_t kMostDots = 1500;  // of A's origin
constexpr size_t kFrames = 9;
constexpr const char* kAxisColour = "#b3261e";
constexpr const char* kSecondColour = "#7c3aed";
constexpr std::array<const char*, 3> kFrameColours = {"#c2410c", "#15803d", "#1d4ed8"};
constexpr double kDeviations = 2;  // half the band's width

// The axis, or the plane's normal, in B.
struct Axis {
  Vector3d point, direction;
  Eigen::Matrix3d point_covariance, direction_covariance;
};

const NamedParameter* Find(const JointPicture& picture, ParameterKind kind, Link frame = Link::kB) {
  for (const NamedParameter& parameter : picture.parameters) {
    if (parameter.kind == kind && parameter.frame == frame && parameter.determined) return &parameter;
  }
  return nullptr;
}

std::optional<Axis> AxisOf(const JointPicture& picture) {
  const NamedParameter* direction = Find(picture, ParameterKind::kDirection);
  const NamedParameter* point = Find(picture, ParameterKind::kPoint);
  if (direction == nullptr || point == nullptr) return std::nullopt;
  return Axis{point->value.head<3>(), direction->value.head<3>(), point->covariance, direction->covariance};
}

// How far the poses reach, in location and in orientation, from the first.
struct Reach {
  double translation = 0, rotation = 0;
};

double Apart(const joint::Transform& a, const joint::Transform& b, const Reach& reach) {
  const double turn = joint::RotationLog(a.R.transpose() * b.R).norm(), way = (a.p - b.p).norm();
  return std::max(reach.translation > 0 ? way / reach.translation : 0,
                  reach.rotation > 0 ? turn / reach.rotation : 0);
}

// Poses far from one another: each the farthest from those before it.
std::vector<joint::Transform> Spread(const std::vector<joint::Transform>& poses, size_t count) {
  Reach reach;
  for (const joint::Transform& pose : poses) {
    reach.translation = std::max(reach.translation, (pose.p - poses[0].p).norm());
    reach.rotation = std::max(reach.rotation, joint::RotationLog(poses[0].R.transpose() * pose.R).norm());
  }
  std::vector<joint::Transform> chosen{poses[0]};
  std::vector<double> nearest(poses.size(), 1e300);
  while (chosen.size() < std::min(count, poses.size())) {
    size_t farthest = 0;
    for (size_t i = 0; i < poses.size(); ++i) {
      nearest[i] = std::min(nearest[i], Apart(poses[i], chosen.back(), reach));
      if (nearest[i] > nearest[farthest]) farthest = i;
    }
    chosen.push_back(poses[farthest]);
  }
  return chosen;
}

// The corrected poses, those of wrong ones left out.
std::vector<joint::Transform> RightPoses(const JointPicture& picture) {
  const std::vector<joint::Transform> corrected = CorrectedPoses(picture.fit);
  std::vector<joint::Transform> right;
  for (size_t i = 0; i < corrected.size(); ++i) {
    if (!std::binary_search(picture.outliers.begin(), picture.outliers.end(), i))
      right.push_back(corrected[i]);
  }
  return right.empty() ? corrected : right;
}

std::vector<joint::Transform> Thinned(const std::vector<joint::Transform>& poses) {
  const size_t step = poses.size() / kMostDots + 1;
  std::vector<joint::Transform> thinned;
  for (size_t i = 0; i < poses.size(); i += step) thinned.push_back(poses[i]);
  return thinned;
}

std::array<double, 3> Triple(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

using Segment = std::pair<Vector3d, Vector3d>;

class Drawing {
 public:
  Drawing(const JointPicture& picture, JointView view);
  std::string Finish();

 private:
  ViewPoint At(const Vector3d& point) const { return projection_.At(Triple(point)); }
  static View ViewOf(const std::optional<Axis>& axis, JointType type, const Vector3d& middle, JointView view);
  std::vector<ViewPoint> Everything() const;
  void DrawBand(SvgCanvas* canvas) const;
  void DrawAxis(SvgCanvas* canvas) const;
  void DrawPoses(SvgCanvas* canvas) const;
  std::optional<Segment> SecondAxis() const;

  const JointPicture& picture_;
  std::vector<joint::Transform> corrected_;
  std::optional<Axis> axis_;
  Vector3d middle_ = Vector3d::Zero();
  double size_ = 1, low_ = 0, high_ = 0;  // of the axis' part that is drawn
  Projection projection_;
};

View Drawing::ViewOf(const std::optional<Axis>& axis, JointType type, const Vector3d& middle,
                     JointView view) {
  View result;
  result.width = 430;
  result.height = 400;
  if (!axis) return view == JointView::kAlongTheAxis ? AlongAxis('z') : result;
  const Vector3d d = axis->direction;
  Vector3d out = middle - axis->point;  // from the axis to where A moves
  out -= d * d.dot(out);
  if (out.norm() < 1e-9) out = d.unitOrthogonal();
  out.normalize();
  const Vector3d side = d.cross(out);
  Vector3d toward, up;
  if (view == JointView::kAlongTheAxis)
    toward = d, up = side;
  else if (type == JointType::kPrismatic)
    toward = out + 0.35 * side + 0.3 * d, up = side;
  else
    toward = -side + 0.45 * d + 0.25 * out, up = d;
  result.toward_viewer = Triple(toward);
  result.up = Triple(up);
  return result;
}

Drawing::Drawing(const JointPicture& picture, JointView view)
    : picture_(picture), corrected_(RightPoses(picture)), axis_(AxisOf(picture)), projection_(View{}) {
  for (const joint::Transform& pose : corrected_) middle_ += pose.p / static_cast<double>(corrected_.size());
  double reach = 0;
  for (const joint::Transform& pose : corrected_) reach = std::max(reach, (pose.p - middle_).norm());
  if (axis_) {
    const Vector3d arm = middle_ - axis_->point;
    reach = std::max(reach, (arm - axis_->direction * axis_->direction.dot(arm)).norm());
    low_ = 1e300, high_ = -1e300;
    for (const joint::Transform& pose : corrected_) {
      const double along = axis_->direction.dot(pose.p - axis_->point);
      low_ = std::min(low_, along), high_ = std::max(high_, along);
    }
  } else if (const NamedParameter* centre = Find(picture, ParameterKind::kPoint)) {
    reach = std::max(reach, (middle_ - centre->value.head<3>()).norm());
  }
  size_ = std::max(reach, 1e-3);
  low_ -= 0.45 * size_, high_ += 0.45 * size_;
  projection_ = Projection(ViewOf(axis_, picture.fit.joint.type, middle_, view));
}

// Of a two-axis joint, where A carries it halfway along the poses.
std::optional<Segment> Drawing::SecondAxis() const {
  const NamedParameter* direction = Find(picture_, ParameterKind::kDirection, Link::kA);
  const NamedParameter* point = Find(picture_, ParameterKind::kPoint, Link::kA);
  if (picture_.fit.joint.type != JointType::kTwoAxis || direction == nullptr || point == nullptr)
    return std::nullopt;
  const joint::Transform& X_BA = corrected_[corrected_.size() / 2];
  const Vector3d half = 0.7 * size_ * (X_BA.R * direction->value.head<3>()),
                 at = X_BA * Vector3d(point->value.head<3>());
  return Segment{at - half, at + half};
}

std::vector<ViewPoint> Drawing::Everything() const {
  std::vector<ViewPoint> points;
  for (const joint::Transform& pose : Thinned(corrected_)) points.push_back(At(pose.p));
  for (const joint::Transform& pose : Spread(corrected_, kFrames)) {
    for (int k = 0; k < 3; ++k) points.push_back(At(pose.p + 0.25 * size_ * pose.R.col(k)));
  }
  if (const auto second = SecondAxis()) {
    points.push_back(At(second->first));
    points.push_back(At(second->second));
  }
  if (axis_) {
    points.push_back(At(axis_->point + low_ * axis_->direction));
    points.push_back(At(axis_->point + high_ * axis_->direction));
  } else if (const NamedParameter* centre = Find(picture_, ParameterKind::kPoint)) {
    points.push_back(At(centre->value.head<3>()));
  }
  return points;
}

// Where the axis lies with two standard deviations to either side, as seen.
void Drawing::DrawBand(SvgCanvas* canvas) const {
  const ViewPoint from = At(axis_->point), to = At(axis_->point + axis_->direction);
  const double dx = to.x - from.x, dy = to.y - from.y, seen = std::hypot(dx, dy);
  const std::string style = "fill=\"#b3261e\" fill-opacity=\"0.18\"";
  if (seen < 1e-6) {
    canvas->Circle(from, kDeviations * std::sqrt(axis_->point_covariance.trace() / 2), style);
    return;
  }
  // The direction in B that is across the axis in the picture.
  Vector3d across;
  for (int k = 0; k < 3; ++k) {
    const ViewPoint unit = At(Vector3d::Unit(k));
    across[k] = (-dy * unit.x + dx * unit.y) / seen;
  }
  const auto half = [&](double along) {
    return kDeviations *
           std::sqrt(std::max(0.0, across.dot(axis_->point_covariance * across) +
                                       along * along * across.dot(axis_->direction_covariance * across)));
  };
  std::vector<ViewPoint> left, right;
  for (int i = 0; i <= 20; ++i) {
    const double along = low_ + (high_ - low_) * i / 20;
    const Vector3d at = axis_->point + along * axis_->direction;
    left.push_back(At(at + half(along) * across));
    right.push_back(At(at - half(along) * across));
  }
  left.insert(left.end(), right.rbegin(), right.rend());
  canvas->Area({left}, style);
}

void Drawing::DrawAxis(SvgCanvas* canvas) const {
  if (!axis_) {
    const NamedParameter* centre = Find(picture_, ParameterKind::kPoint);
    if (centre == nullptr || picture_.fit.joint.type != JointType::kSpherical) return;
    const ViewPoint at = At(centre->value.head<3>());
    canvas->Circle(at, kDeviations * centre->expected_error / std::sqrt(3),
                   "fill=\"#b3261e\" fill-opacity=\"0.18\"");
    canvas->Mark(at, false, false, kAxisColour);
    return;
  }
  const Vector3d from = axis_->point + low_ * axis_->direction, to = axis_->point + high_ * axis_->direction;
  const ViewPoint start = At(from), end = At(to);
  if (std::hypot(end.x - start.x, end.y - start.y) < 0.05 * (high_ - low_))
    canvas->SightRing(At(axis_->point), end.z > start.z, kAxisColour);
  else
    canvas->Arrow(start, end, kAxisColour);
}

void Drawing::DrawPoses(SvgCanvas* canvas) const {
  std::vector<std::pair<ViewPoint, ViewPoint>> way, observed, wrong;
  const std::vector<joint::Transform> thinned = Thinned(corrected_);
  for (size_t i = 1; i < thinned.size(); ++i) way.emplace_back(At(thinned[i - 1].p), At(thinned[i].p));
  const size_t step = picture_.poses.size() / kMostDots + 1;
  for (size_t i = 0; i < picture_.poses.size(); i += step) {
    // A wrong pose may lie anywhere; only those near enough are shown.
    const bool is_wrong = std::binary_search(picture_.outliers.begin(), picture_.outliers.end(), i);
    if ((picture_.poses[i].p - middle_).norm() > 3 * size_) continue;
    (is_wrong ? wrong : observed).emplace_back(At(picture_.poses[i].p), At(picture_.poses[i].p));
  }
  canvas->Lines(observed, "stroke=\"#8a867d\" stroke-width=\"4\" stroke-opacity=\"0.55\"");
  canvas->Lines(wrong, "stroke=\"#d97706\" stroke-width=\"6\"");
  canvas->Lines(way, "stroke=\"#1d1c1a\" stroke-width=\"1.4\"");
  for (const joint::Transform& pose : Spread(corrected_, kFrames)) {
    for (int k = 0; k < 3; ++k) {
      canvas->Lines({{At(pose.p), At(pose.p + 0.22 * size_ * pose.R.col(k))}},
                    "stroke-width=\"1.7\" stroke=\"" + std::string(kFrameColours[k]) + "\"");
    }
  }
}

std::string Drawing::Finish() {
  SvgCanvas canvas(Everything(), 430, 400);
  if (axis_) DrawBand(&canvas);
  DrawPoses(&canvas);
  if (const auto second = SecondAxis()) canvas.Arrow(At(second->first), At(second->second), kSecondColour);
  DrawAxis(&canvas);
  std::vector<SvgCanvas::Axis> triad;
  for (int k = 0; k < 3; ++k)
    triad.push_back({std::string(1, "xyz"[k]), At(Vector3d::Unit(k)), kFrameColours[k]});
  canvas.Triad(std::move(triad));
  return canvas.Finish("The poses of A in B and the joint");
}

}  // namespace

std::string DrawJoint(const JointPicture& picture, JointView view) { return Drawing(picture, view).Finish(); }

}  // namespace tact::provers
