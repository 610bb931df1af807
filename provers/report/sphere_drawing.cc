#include "provers/report/sphere_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include "algebra/cone/cone.h"
#include "algebra/error.h"
#include "algebra/exact/linear_algebra.h"
#include "provers/report/svg_canvas.h"

namespace tact::provers {
namespace {

using algebra::IntegerMatrix;
using algebra::Rational;
using algebra::Vector3;
using Curve = std::vector<ViewPoint>;

constexpr const char* kLegal = "#1f8a70";
constexpr const char* kMaintaining = "#c8402f";
constexpr double kStep = std::numbers::pi / 60;  // of arcs, in radians: below a pixel from the true curve

IntegerMatrix NormalsOf(const algebra::ContactRelation& relation) {
  std::vector<std::vector<Rational>> rows;
  for (const algebra::Contact& contact : relation.contacts) {
    if (contact.planes.size() != 1 || contact.planes.front().IsZero()) {
      throw PreconditionError(
          "DrawLegalDirections: expected contacts with one plane whose normal is not zero, got " +
          std::to_string(contact.planes.size()) + " planes at " + ToString(contact.point));
    }
    const Vector3& n = contact.planes.front();
    rows.push_back({n.x, n.y, n.z});
  }
  return IntegerMatrix::FromRationalRows(rows, 3);
}

// Directions { v | A v >= 0 } or, of the same rows, { v | A v = 0 }.
struct Directions {
  algebra::HalfspaceCone cone;
  size_t dimension = 0;
};

Directions Legal(const IntegerMatrix& normals) {
  algebra::HalfspaceCone cone(normals);
  const size_t dimension = Dimension(Generators(cone).cone);
  return {std::move(cone), dimension};
}

Directions Maintaining(const IntegerMatrix& normals) {
  return {algebra::HalfspaceCone(IntegerMatrix(0, 3), normals), 3 - Rank(normals)};
}

SphereRegion RegionOf(size_t legal, size_t maintaining) {
  using enum SphereRegion;
  constexpr std::array<std::array<SphereRegion, 4>, 4> kRegions = {{
      {kNothing},
      {kPoint, kOppositePoints},
      {kArc, kHalfCircle, kGreatCircle},
      {kConvexPolygon, kLune, kHemisphere, kWholeSphere},
  }};
  return kRegions.at(legal).at(maintaining);
}

// What of the directions lies in one octant of the view; as large as the whole, so that touching an octant in
// an edge or a corner does not count. An octant's part is pointed: a corner, an arc below a half circle, or a
// triangle or so, counter-clockwise or clockwise.
struct Piece {
  std::vector<Vector3> corners;
  bool front = false;
};

std::array<Vector3, 3> ViewAxes(const View& view) {
  const auto exact = [](const std::array<double, 3>& v) {
    return Vector3{Rational::FromShortestDecimal(v[0]), Rational::FromShortestDecimal(v[1]),
                   Rational::FromShortestDecimal(v[2])};
  };
  const Vector3 toward = exact(view.toward_viewer), right = Cross(exact(view.up), toward);
  return {toward, right, Cross(toward, right)};
}

std::vector<Piece> CutByOctants(const Directions& directions, const View& view) {
  const std::array<Vector3, 3> axes = ViewAxes(view);
  std::vector<Piece> pieces;
  std::set<std::vector<Vector3>> seen;  // arcs and points between octants
  for (int octant = 0; octant < 8; ++octant) {
    std::vector<std::vector<Rational>> rows;
    for (int i = 0; i < 3; ++i) {
      const Vector3 side = (octant >> (2 - i)) % 2 == 0 ? axes[i] : -axes[i];
      rows.push_back({side.x, side.y, side.z});
    }
    algebra::HalfspaceCone cone = directions.cone;
    cone.inequalities.AppendRows(IntegerMatrix::FromRationalRows(rows, 3));
    const algebra::GeneratorCone part = Generators(cone).cone;
    if (directions.dimension == 0 || Dimension(part) < directions.dimension) continue;
    Piece piece{{}, octant < 4};
    for (size_t i = 0; i < part.rays.rows; ++i) {
      piece.corners.push_back({part.rays(i, 0), part.rays(i, 1), part.rays(i, 2)});
    }
    const Vector3 pivot = piece.corners.front();
    std::sort(piece.corners.begin() + 1, piece.corners.end(),
              [&](const Vector3& a, const Vector3& b) { return Dot(pivot, Cross(a, b)).sign() > 0; });
    if (seen.insert(piece.corners).second) pieces.push_back(std::move(piece));
  }
  return pieces;
}

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
      : view_(view), project_(project), canvas_(Corners(project), view.width, view.height, false) {}

  void Draw(const IntegerMatrix& normals) {
    const Directions legal = Legal(normals), maintaining = Maintaining(normals);
    const std::vector<Piece> legal_pieces = CutByOctants(legal, view_),
                             maintaining_pieces = CutByOctants(maintaining, view_);
    canvas_.Circle({}, 1, "fill=\"#eef1f4\"");
    DrawAxes(false);  // seen through the sphere
    DrawSide(false, normals, legal, legal_pieces, maintaining, maintaining_pieces);
    DrawGlaze();
    DrawSide(true, normals, legal, legal_pieces, maintaining, maintaining_pieces);
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

  void DrawSide(bool front, const IntegerMatrix& normals, const Directions& legal,
                const std::vector<Piece>& legal_pieces, const Directions& maintaining,
                const std::vector<Piece>& maintaining_pieces) {
    const bool all_maintain = legal.dimension == maintaining.dimension;
    if (!all_maintain && legal.dimension == 3) Fill(front, legal_pieces, kLegal);
    if (maintaining.dimension == 3) Fill(front, maintaining_pieces, kMaintaining);
    DrawGrid(front);
    if (!all_maintain) DrawCurves(front, legal.dimension, legal_pieces, normals, kLegal);
    DrawCurves(front, maintaining.dimension, maintaining_pieces, normals, kMaintaining);
  }

  Curve ArcsThrough(const std::vector<Vector3>& corners) const {
    Curve curve;
    for (size_t i = 0; i < corners.size(); ++i) {
      AppendArc(curve, project_.Direction(corners[i]), project_.Direction(corners[(i + 1) % corners.size()]));
    }
    return curve;
  }

  // One path, so that no seams show between octants.
  void Fill(bool front, const std::vector<Piece>& pieces, const char* colour) {
    std::vector<Curve> loops;
    for (const Piece& piece : pieces) {
      if (piece.front == front) loops.push_back(ArcsThrough(piece.corners));
    }
    if (!loops.empty()) {
      canvas_.Area(loops, fmt::format("fill=\"{}\" fill-opacity=\"{}\"", colour, front ? 0.55 : 0.3));
    }
  }

  // The border of areas, as far as normals make it; arcs and points as they are.
  void DrawCurves(bool front, size_t dimension, const std::vector<Piece>& pieces,
                  const IntegerMatrix& normals, const char* colour) {
    std::vector<std::pair<ViewPoint, ViewPoint>> lines;
    const auto add = [&](const Vector3& a, const Vector3& b) {
      Curve curve;
      AppendArc(curve, project_.Direction(a), project_.Direction(b));
      curve.push_back(project_.Direction(b));
      const auto arc = LinesOf(curve);
      lines.insert(lines.end(), arc.begin(), arc.end());
    };
    for (const Piece& piece : pieces) {
      if (piece.front != front) continue;
      const size_t n = piece.corners.size();
      if (dimension == 1) canvas_.Mark(project_.Direction(piece.corners[0]), false, !front, colour);
      if (dimension == 2) add(piece.corners[0], piece.corners[1]);
      for (size_t i = 0; dimension == 3 && i < n; ++i) {
        const Vector3 &a = piece.corners[i], &b = piece.corners[(i + 1) % n];
        if (OnOneBorder(normals, a, b)) add(a, b);
      }
    }
    canvas_.Lines(lines,
                  fmt::format("stroke=\"{}\" stroke-width=\"{}\"{}", colour, dimension == 2 ? 3.4 : 1.6,
                              front ? "" : " stroke-dasharray=\"5 5\" stroke-opacity=\"0.75\""));
  }

  static bool OnOneBorder(const IntegerMatrix& normals, const Vector3& a, const Vector3& b) {
    for (size_t i = 0; i < normals.rows; ++i) {
      const Vector3 n = {normals(i, 0), normals(i, 1), normals(i, 2)};
      if (Dot(n, a).sign() == 0 && Dot(n, b).sign() == 0) return true;
    }
    return false;
  }

  const View& view_;
  const Projection& project_;
  SvgCanvas canvas_;
};

}  // namespace

std::string NameOf(SphereRegion region) {
  constexpr std::array<const char*, 10> kNames = {
      "whole sphere", "hemisphere",          "lune",  "convex polygon", "great circle", "half circle",
      "arc",          "two opposite points", "point", "nothing"};
  return kNames.at(static_cast<size_t>(region));
}

SphereRegion LegalDirections(const algebra::ContactRelation& relation) {
  const IntegerMatrix normals = NormalsOf(relation);
  return RegionOf(Legal(normals).dimension, Maintaining(normals).dimension);
}

std::string DrawLegalDirections(const algebra::ContactRelation& relation, const View& view) {
  const Projection project(view);
  SphereDrawing drawing(view, project);
  drawing.Draw(NormalsOf(relation));
  return drawing.Finish("sphere of directions, legal translations: " + NameOf(LegalDirections(relation)));
}

}  // namespace tact::provers
