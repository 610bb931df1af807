#include "provers/report/trajectory_drawing.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "algebra/contact/contact_finder.h"
#include "algebra/error.h"
#include "provers/report/solid_drawing.h"
#include "robot/planning/trajectory_check.h"

namespace tact::provers {
namespace {

using planning::Sample;
using planning::SolidPair;

constexpr size_t kGhosts = 6;        // of the way, its start among them
constexpr double kElevation = 0.35;  // the viewer's height over its distance

View From(double azimuth) {
  View view;
  view.toward_viewer = {std::cos(azimuth), std::sin(azimuth), kElevation};
  return view;
}

double SeenMotion(const SolidPair& solids, const std::vector<Sample>& samples, const View& view) {
  const Eigen::Vector3d sight =
      Eigen::Vector3d(view.toward_viewer[0], view.toward_viewer[1], view.toward_viewer[2]).normalized();
  double seen = 0;
  for (const Eigen::Vector3d& vertex : solids.moving_f.vertices) {
    const Eigen::Vector3d way = samples.back().X_FM * vertex - samples.front().X_FM * vertex;
    seen += (way - sight.dot(way) * sight).norm();
  }
  return seen;
}

}  // namespace

View ViewOfMotion(const SolidPair& solids, const std::vector<Sample>& samples) {
  constexpr int kViews = 12;
  // Straight at an axis hides depth: the views are a little beside the axes.
  View best;
  double most = -1;
  for (int i = 0; i < kViews; ++i) {
    const View view = From(-std::numbers::pi / 2 + 0.2 + 2 * std::numbers::pi * i / kViews);
    const double seen = SeenMotion(solids, samples, view);
    if (seen > most * 1.05) {  // the first of views that are about as good
      most = seen;
      best = view;
    }
  }
  return best;
}

std::string DrawTrajectory(const SolidPair& solids, const std::vector<Sample>& samples) {
  if (samples.empty()) throw PreconditionError("expected samples of a trajectory, got none");
  const auto at = [&](size_t i) {
    return algebra::Transform(solids.moving, planning::ExactPose(samples[i].X_FM));
  };
  const size_t last = samples.size() - 1;
  std::vector<DrawnSolid> drawn = {{solids.fixed, Part::kFixed}, {at(last), Part::kMoving}};
  const size_t ghosts = std::min(kGhosts, last);
  for (size_t g = 0; g < ghosts; ++g) drawn.push_back({at(g * last / ghosts), Part::kOutline});
  const auto tolerance = algebra::Rational::FromShortestDecimal(planning::kOverlapTolerance * solids.size);
  const auto contacts = FindContacts(drawn[1].solid, solids.fixed, tolerance);
  return DrawContactRelation(drawn, contacts.relation, ViewOfMotion(solids, samples));
}

}  // namespace tact::provers
