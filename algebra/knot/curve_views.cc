#include "algebra/knot/curve_views.h"

#include <optional>

namespace tact::knot {
namespace {

using algebra::Rational;
using algebra::Vector3;

constexpr size_t kViews = 33;

// number's digits in that base behind the point, the last one first: within (0, 1).
Rational RadicalInverse(int number, int base) {
  Rational value, place(1);
  for (; number > 0; number /= base) {
    place /= Rational(base);
    value += place * Rational(number % base);
  }
  return value;
}

int Intersections(const ProjectedCurves& projected) {
  int count = 0;
  for (const CurveProjection& projection : projected.projections) count += projection.p.crossings();
  return count;
}

}  // namespace

std::vector<Vector3> CandidateViews() {
  std::vector<Vector3> views = {ViewFromAbove()};
  for (int k = 1; views.size() < kViews; ++k) {
    const Rational u = 2 * RadicalInverse(k, 2) - 1, v = 2 * RadicalInverse(k, 3) - 1;
    const Rational up = 1 - u * u - v * v;
    if (up.sign() > 0) views.push_back(algebra::Primitive({2 * u, 2 * v, up}));
  }
  return views;
}

std::variant<ProjectedCurves, FaultyCurve> ProjectCurves(const std::vector<Curve>& curves,
                                                         const Vector3& view) {
  ProjectedCurves projected;
  projected.view = view;
  for (size_t i = 0; i < curves.size(); ++i) {
    auto projection = ProjectCurve(curves[i], view);
    if (const auto* fault = std::get_if<CurveFault>(&projection)) return FaultyCurve{i, *fault};
    projected.projections.push_back(std::get<CurveProjection>(std::move(projection)));
  }
  return projected;
}

std::variant<ProjectedCurves, FaultyCurve> ProjectCurvesFromBestView(const std::vector<Curve>& curves) {
  std::optional<ProjectedCurves> best;
  std::optional<FaultyCurve> first_fault;
  int faulty_views = 0;
  const std::vector<Vector3> views = CandidateViews();
  for (const Vector3& view : views) {
    auto tried = ProjectCurves(curves, view);
    if (const auto* faulty = std::get_if<FaultyCurve>(&tried)) {
      if (!faulty->fault.of_view()) return *faulty;
      if (!first_fault) first_fault = *faulty;
      ++faulty_views;
      continue;
    }
    auto& projected = std::get<ProjectedCurves>(tried);
    if (!best || Intersections(projected) < Intersections(*best)) best = std::move(projected);
  }
  if (!best) return *first_fault;
  best->views = static_cast<int>(views.size());
  best->faulty_views = faulty_views;
  return *std::move(best);
}

}  // namespace tact::knot
