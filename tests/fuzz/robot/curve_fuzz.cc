// Any bytes are rope curves, or are refused as bad input with a place. From whatever view: a fault names points that there
// are, and a projection is P-data of a sphere, read the other way round from the other end, and mirrored from behind.
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "algebra/error.h"
#include "algebra/knot/faces.h"
#include "robot/input/curve_text.h"

namespace {

using namespace tact;  // NOLINT: a program of one file

void Require(bool holds) {
  if (!holds) std::abort();
}

void CheckCurve(const knot::Curve& curve, const algebra::Vector3& view) {
  const auto projection = knot::ProjectCurve(curve, view);
  knot::Curve reversed = curve;
  std::reverse(reversed.begin(), reversed.end());
  const auto other_end = knot::ProjectCurve(reversed, view), from_behind = knot::ProjectCurve(curve, -view);
  if (const auto* fault = std::get_if<knot::CurveFault>(&projection)) {
    const int points = static_cast<int>(curve.size());
    for (const int point : fault->points) Require(point >= 1 && point <= points);
    Require(fault->what().starts_with("expected "));
    Require(std::get<knot::CurveFault>(other_end).kind == fault->kind);
    Require(std::get<knot::CurveFault>(from_behind).kind == fault->kind);
    return;
  }
  const knot::PData& p = std::get<knot::CurveProjection>(projection).p;
  Require(!knot::PData::FindFault(p.SigmaRow(), p.AttrRow()) && knot::IsPlanar(p));
  Require(std::get<knot::CurveProjection>(other_end).p == EquivalentPData(p));
  Require(std::get<knot::CurveProjection>(from_behind).p == MirrorShape(MirrorHeights(p)));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::vector<input::CurveText> curves;
  try {
    curves = input::ParseCurves({text, "fuzz", 1});
  } catch (const InputError& error) {
    Require(std::string(error.what()).starts_with("fuzz:"));
    return 0;
  }
  for (const input::CurveText& curve : curves) {
    Require(!curve.points.empty() && curve.points.size() == curve.offsets.size());
    for (const algebra::Vector3& view : {knot::ViewFromAbove(), {1, 0, 0}, {-3, 2, 5}, {0, 1, -1}})
      CheckCurve(curve.points, view);
  }
  return 0;
}
