#include "provers/report/sphere_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "provers/report/svg_canvas.h"

namespace tact::provers {
namespace {

using algebra::Vector3;
using Curve = std::vector<ViewPoint>;

constexpr const char* kLegal = "#1f8a70";
constexpr const char* kMaintaining = "#c8402f";
constexpr double kStep = std::numbers::pi / 60;  // of arcs, in radians: below a pixel from the true curve

// From a on, to b but without it; the two are neither equal nor opposite.
void AppendArc(Curve& curve, const ViewPoint& a, const ViewPoint& b) {
  const double angle = std::acos(std::clamp(a.x * b.x + a.y * b.y + a.z * b.z, -1.0, 1.0));
  const int steps = std::max(1, static_cast<int>(std::ceil(angle / kStep)));
  for (int i = 0; i < steps; ++i) {
    const double s = steps == 1 ? 1 : std::sin(angle * (steps - i) / steps) / std::sin(angle);
    const double t = steps == 1 ? 0 : std::sin(angle * i / steps) / std::sin(angle);
    curve.push_back({s * a.x + t * b.x, s * a.y + t * b.y, s * a.z + t * b.z});
  }
}

std::vector<std::pair<ViewPoint, ViewPoint>> LinesOf(const Curve& curve) {
  std::vector<std::pair<ViewPoint, ViewPoint>> lines;
  for (size_t i = 0; i + 1 < curve.size(); ++i) lines.emplace_back(curve[i], curve[i + 1]);
  return lines;
}

class SphereDrawing {
 public:
  SphereDrawing(const View& view, const Projection& project)
      : project_(project), canvas_(Corners(project), view.width, view.height, false) {}

  void Draw(const SphereSets& sets) {
    canvas_.Circle({}, 1, "fill=\"#eef1f4\"");
    DrawAxes(false);  // seen through the sphere
    DrawSide(sets, false);
    DrawGlaze();
    DrawSide(sets, true);
    canvas_.Circle({}, 1, "fill=\"none\" stroke=\"#5c6670\" stroke-width=\"1.2\"");
    DrawAxes(true);
  }
  std::string Finish(const std::string& title) const { return canvas_.Finish(title); }

 private:
  static constexpr double kAxisTip = 1.45, kReach = 1.6;

  static std::vector<ViewPoint> Corners(const Projection& project) {
    std::vector<ViewPoint> corners = {{-1, -1, 0}, {1, 1, 0}};
    for (int i = 0; i < 3; ++i) corners.push_back(OnAxis(project, i, kReach));
    return corners;
  }

  static ViewPoint OnAxis(const Projection& project, int axis, double length) {
    Vector3 v;
    v[axis] = 1;
    const ViewPoint d = project.Direction(v);
    return {length * d.x, length * d.y, length * d.z};
  }

  // Those that point to the viewer, or those that do not.
  void DrawAxes(bool front) {
    constexpr std::array<std::pair<const char*, const char*>, 3> kAxes = {
        {{"x", "#a3231b"}, {"y", "#226b2a"}, {"z", "#1d4f91"}}};
    for (int i = 0; i < 3; ++i) {
      const ViewPoint tip = OnAxis(project_, i, kAxisTip);
      if ((tip.z > 0) == front) {
        canvas_.NamedArrow(OnAxis(project_, i, 1), tip, kAxes[i].first, kAxes[i].second);
      }
    }
  }

  // Light from the upper left, over the far side.
  void DrawGlaze() {
    canvas_.Circle({}, 1, "fill=\"#ffffff\" fill-opacity=\"0.25\"");
    constexpr int kRings = 9;
    for (int ring = 1; ring < kRings; ++ring) {
      const double inward = static_cast<double>(ring) / kRings;
      canvas_.Circle({-0.38 * inward, 0.45 * inward, 0}, 1 - inward,
                     "fill=\"#ffffff\" fill-opacity=\"0.09\"");
    }
  }

  // The circles in the coordinate planes.
  void DrawGrid(bool front) {
    std::vector<std::pair<ViewPoint, ViewPoint>> lines;
    for (int axis = 0; axis < 3; ++axis) {
      const ViewPoint u = OnAxis(project_, (axis + 1) % 3, 1), v = OnAxis(project_, (axis + 2) % 3, 1);
      Curve circle;
      for (int step = 0; step <= 120; ++step) {
        const double c = std::cos(kStep * step), d = std::sin(kStep * step);
        circle.push_back({c * u.x + d * v.x, c * u.y + d * v.y, c * u.z + d * v.z});
      }
      for (const auto& line : LinesOf(circle)) {
        if ((line.first.z + line.second.z > 0) == front) lines.push_back(line);
      }
    }
    canvas_.Lines(lines, front ? "stroke=\"#7c8894\" stroke-width=\"0.7\" stroke-opacity=\"0.7\""
                               : "stroke=\"#7c8894\" stroke-width=\"0.6\" stroke-opacity=\"0.3\"");
  }

  void DrawSide(const SphereSets& sets, bool front) {
    const bool all_maintain = sets.legal.dimension == sets.maintaining.dimension;
    if (!all_maintain) Fill(sets.legal, front, kLegal);
    Fill(sets.maintaining, front, kMaintaining);
    DrawGrid(front);
    if (!all_maintain) DrawCurves(sets.legal, front, kLegal);
    DrawCurves(sets.maintaining, front, kMaintaining);
  }

  Curve ArcsThrough(const std::vector<Vector3>& corners) const {
    Curve curve;
    for (size_t i = 0; i < corners.size(); ++i) {
      AppendArc(curve, project_.Direction(corners[i]), project_.Direction(corners[(i + 1) % corners.size()]));
    }
    return curve;
  }

  // One path, so that no seams show between octants.
  void Fill(const SphereSet& set, bool front, const char* colour) {
    std::vector<Curve> loops;
    for (const SpherePiece& piece : set.pieces) {
      if (set.dimension == 3 && piece.front == front) loops.push_back(ArcsThrough(piece.corners));
    }
    if (!loops.empty()) {
      canvas_.Area(loops, fmt::format("fill=\"{}\" fill-opacity=\"{}\"", colour, front ? 0.55 : 0.3));
    }
  }

  // The border of areas; arcs and points as they are.
  void DrawCurves(const SphereSet& set, bool front, const char* colour) {
    std::vector<std::pair<ViewPoint, ViewPoint>> lines;
    for (const SpherePiece& piece : set.pieces) {
      if (piece.front != front) continue;
      const size_t n = piece.corners.size();
      if (n == 1) canvas_.Mark(project_.Direction(piece.corners[0]), false, !front, colour);
      for (size_t i = 0; i < (n == 2 ? 1 : n); ++i) {
        if (n == 1 || !piece.border[i]) continue;
        const ViewPoint end = project_.Direction(piece.corners[(i + 1) % n]);
        Curve curve;
        AppendArc(curve, project_.Direction(piece.corners[i]), end);
        curve.push_back(end);
        const auto arc = LinesOf(curve);
        lines.insert(lines.end(), arc.begin(), arc.end());
      }
    }
    canvas_.Lines(lines,
                  fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", colour, set.dimension == 2 ? 3.4 : 1.6,
                              front ? "" : " stroke-dasharray=\"5 5\" stroke-opacity=\"0.75\""));
  }

  const Projection& project_;
  SvgCanvas canvas_;
};

}  // namespace

std::string DrawLegalDirections(const algebra::ContactRelation& relation, const View& view) {
  const Projection project(view);
  SphereDrawing drawing(view, project);
  drawing.Draw(CutIntoPieces(relation, view));
  return drawing.Finish("sphere of directions, legal translations: " + NameOf(LegalDirections(relation)));
}

}  // namespace tact::provers
