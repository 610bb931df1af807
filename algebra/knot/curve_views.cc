#include "algebra/knot/curve_views.h"

#include <array>
#include <optional>

namespace tact::knot {

using algebra::Vector3;

int ProjectedCurves::Intersections() const {
  int count = 0;
  for (const CurveProjection& projection : projections) count += projection.p.crossings();
  return count;
}

std::vector<Vector3> CandidateViews() {
  constexpr std::array<std::array<int, 3>, 5> kNumbers = {
      {{2, 3, 6}, {1, 2, 2}, {2, 6, 3}, {2, 2, 1}, {3, 6, 2}}};
  std::vector<Vector3> views = {ViewFromAbove()};
  for (const auto& [a, b, up] : kNumbers) {
    for (const bool exchanged : {false, true}) {
      if (exchanged && a == b) continue;
      const int x = exchanged ? b : a, y = exchanged ? a : b;
      for (const int x_sign : {1, -1})
        for (const int y_sign : {1, -1}) views.push_back({x_sign * x, y_sign * y, up});
    }
  }
  return views;
}

std::variant<ProjectedCurves, FaultyCurve> ProjectCurves(const std::vector<Curve>& curves,
                                                         const Vector3& view, int most_intersections) {
  ProjectedCurves projected;
  projected.view = view;
  for (size_t i = 0; i < curves.size(); ++i) {
    auto projection = ProjectCurve(curves[i], view, most_intersections);
    if (const auto* fault = std::get_if<CurveFault>(&projection)) return FaultyCurve{i, *fault};
    projected.projections.push_back(std::get<CurveProjection>(std::move(projection)));
    most_intersections -= projected.projections.back().p.crossings();
  }
  return projected;
}

std::variant<ProjectedCurves, FaultyCurve> ProjectCurvesFromBestView(const std::vector<Curve>& curves) {
  std::optional<ProjectedCurves> best;
  std::optional<FaultyCurve> first_fault;
  int most = kMostCurveIntersections;
  const std::vector<Vector3> views = CandidateViews();
  for (const Vector3& view : views) {
    auto tried = ProjectCurves(curves, view, most);
    if (const auto* faulty = std::get_if<FaultyCurve>(&tried)) {
      if (!faulty->fault.of_view()) return *faulty;
      if (!first_fault) first_fault = *faulty;
      continue;
    }
    best = std::get<ProjectedCurves>(std::move(tried));
    if (best->Intersections() == 0) break;
    most = best->Intersections() - 1;
  }
  if (!best) return *first_fault;
  best->views = static_cast<int>(views.size());
  return *std::move(best);
}

}  // namespace tact::knot
