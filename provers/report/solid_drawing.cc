#include "provers/report/solid_drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <set>

#include "provers/report/paint_order.h"
#include "provers/report/svg_canvas.h"

namespace tact::provers {
namespace {

constexpr double kArrowShare = 0.12;  // of the drawing's larger side
constexpr double kEdgeOn = 1e-9;      // a unit normal's z below this: the face is seen from its edge

struct PaintedFace {
  Part part;
  std::string style;
  std::vector<std::pair<ViewPoint, ViewPoint>> convex, concave, thin;
};

struct Arrow {
  ViewPoint from, to;
  bool singular = false;
  double toward_viewer = 0;  // the unit normal's part along the line of sight
};

std::string FaceStyle(Part part, const ViewPoint& normal) {
  if (part == Part::kOutline) return "fill=\"none\"";
  const bool front = normal.z > 0;
  const double side = front ? 1 : -1;
  const double light = std::max(0.0, side * (-0.40 * normal.x + 0.62 * normal.y + 0.67 * normal.z));
  const double shade = 0.66 + 0.34 * light;
  const std::array<double, 3> base = part == Part::kMoving ? std::array{246.0, 196.0, 108.0}
                                     : part == Part::kWall ? std::array{150.0, 192.0, 230.0}
                                     : front               ? std::array{176.0, 200.0, 222.0}
                                                           : std::array{214.0, 226.0, 236.0};
  const double opacity = part == Part::kMoving ? 0.93
                         : part == Part::kWall ? (front ? 0.62 : 0.16)
                                               : (front ? 0.42 : 0.8);
  return fmt::format("fill=\"#{:02x}{:02x}{:02x}\" fill-opacity=\"{}\" fill-rule=\"evenodd\"",
                     static_cast<int>(base[0] * shade), static_cast<int>(base[1] * shade),
                     static_cast<int>(base[2] * shade), opacity);
}

// The solids' faces that the drawing shows: not those seen from their edge, not the moving solid's far ones.
void CollectFaces(const std::vector<DrawnSolid>& solids, const Projection& project,
                  std::vector<FlatFace>& flat, std::vector<PaintedFace>& painted) {
  for (const DrawnSolid& drawn : solids) {
    std::vector<ViewPoint> points;
    for (const algebra::Vertex& vertex : drawn.solid.vertices) points.push_back(project(vertex.point));
    for (const algebra::Face& face : drawn.solid.faces) {
      const ViewPoint normal = project.Direction(face.normal);
      if (std::abs(normal.z) < kEdgeOn || (drawn.part == Part::kMoving && normal.z < 0)) continue;
      FlatFace outline{{}, normal};
      PaintedFace paint{drawn.part, FaceStyle(drawn.part, normal), {}, {}, {}};
      for (const auto& loop : face.loops) {
        std::vector<ViewPoint>& corners = outline.loops.emplace_back();
        for (const size_t vertex : loop) corners.push_back(points.at(vertex));
      }
      for (const auto& loop : face.loop_edges) {
        for (const size_t index : loop) {
          const algebra::Edge& edge = drawn.solid.edges.at(index);
          auto& lines = drawn.part == Part::kWall || drawn.part == Part::kOutline ? paint.thin
                        : edge.convexity == algebra::Convexity::kConvex           ? paint.convex
                                                                                  : paint.concave;
          lines.emplace_back(points.at(edge.tail), points.at(edge.head));
        }
      }
      flat.push_back(std::move(outline));
      painted.push_back(std::move(paint));
    }
  }
}

std::vector<Arrow> CollectArrows(const algebra::ContactRelation& relation, const Projection& project,
                                 double length) {
  std::vector<Arrow> arrows;
  for (const algebra::Contact& contact : relation.contacts) {
    const ViewPoint from = project(contact.point);
    for (const algebra::Vector3& normal : contact.planes) {
      const ViewPoint n = project.Direction(normal);
      arrows.push_back({from,
                        {from.x + length * n.x, from.y + length * n.y, from.z + length * n.z},
                        contact.singular(),
                        n.z});
    }
  }
  return arrows;
}

void DrawFaces(SvgCanvas& canvas, const std::vector<FlatFace>& flat, const std::vector<PaintedFace>& painted,
               double margin) {
  for (const size_t i : PaintOrder(flat, margin)) {
    canvas.Area(flat[i].loops, painted[i].style);
    canvas.Lines(painted[i].convex, "stroke=\"#35332f\" stroke-width=\"1\"");
    canvas.Lines(painted[i].concave, "stroke=\"#7b2fa8\" stroke-width=\"2.2\"");
    canvas.Lines(painted[i].thin,
                 painted[i].part == Part::kWall
                     ? "stroke=\"#4b6f93\" stroke-width=\"0.9\""
                     : "stroke=\"#8fa3b5\" stroke-width=\"0.9\" stroke-dasharray=\"0.1 3.2\"");
  }
}

const char* ContactColour(bool singular) { return singular ? "#b5127a" : "#0a4fa8"; }

void DrawArrows(SvgCanvas& canvas, const std::vector<Arrow>& arrows) {
  constexpr double kSightline = 0.985;  // beyond this an arrow is too short to read
  std::set<std::string> seen;           // contacts behind one another look the same
  for (const Arrow& arrow : arrows) {
    const std::string key = canvas.Key(arrow.from) + canvas.Key(arrow.to);
    if (!seen.insert(key).second) continue;
    const std::string colour = ContactColour(arrow.singular);
    if (std::abs(arrow.toward_viewer) > kSightline) {
      canvas.SightRing(arrow.from, arrow.toward_viewer > 0, colour);
    } else {
      canvas.Arrow(arrow.from, arrow.to, colour);
    }
  }
}

void DrawContacts(SvgCanvas& canvas, const algebra::ContactRelation& relation, const Projection& project,
                  const std::vector<FlatFace>& flat, const std::vector<PaintedFace>& painted, double margin) {
  // Hollow marks first: where contacts lie behind one another the one in sight stays on top.
  for (const bool hollow : {true, false}) {
    std::set<std::string> seen;
    for (const algebra::Contact& contact : relation.contacts) {
      const ViewPoint p = project(contact.point);
      bool hidden = false;
      for (size_t i = 0; i < flat.size() && !hidden; ++i) {
        hidden = painted[i].part == Part::kMoving && Covers(flat[i], p.x, p.y, 0) &&
                 DepthAt(flat[i], p.x, p.y) > p.z + margin;
      }
      if (hidden != hollow || !seen.insert(canvas.Key(p) + (contact.singular() ? "s" : "")).second) continue;
      canvas.Mark(p, contact.singular(), hollow, ContactColour(contact.singular()));
    }
  }
}

void DrawTriad(SvgCanvas& canvas, const Projection& project) {
  canvas.Triad({{"x", project({1, 0, 0}), "#a3231b"},
                {"y", project({0, 1, 0}), "#226b2a"},
                {"z", project({0, 0, 1}), "#1d4f91"}});
}

}  // namespace

std::string DrawContactRelation(const std::vector<DrawnSolid>& solids,
                                const algebra::ContactRelation& relation, const View& view) {
  const Projection project(view);
  std::vector<FlatFace> flat;
  std::vector<PaintedFace> painted;
  CollectFaces(solids, project, flat, painted);

  std::vector<ViewPoint> seen;
  for (const DrawnSolid& drawn : solids) {
    for (const algebra::Face& face : drawn.solid.faces) {
      for (const size_t vertex : face.loops.at(0)) {
        seen.push_back(project(drawn.solid.vertices.at(vertex).point));
      }
    }
  }
  for (const algebra::Contact& contact : relation.contacts) seen.push_back(project(contact.point));
  const double extent = Extent(seen) > 0 ? Extent(seen) : 1;
  const std::vector<Arrow> arrows = CollectArrows(relation, project, kArrowShare * extent);
  for (const Arrow& arrow : arrows) seen.push_back(arrow.to);

  const double margin = 1e-7 * extent;  // what doubles leave of touching, far below a pixel
  SvgCanvas canvas(seen, view.width, view.height);
  DrawFaces(canvas, flat, painted, margin);
  DrawArrows(canvas, arrows);
  DrawContacts(canvas, relation, project, flat, painted, margin);
  DrawTriad(canvas, project);
  const auto singular = std::count_if(relation.contacts.begin(), relation.contacts.end(),
                                      [](const algebra::Contact& contact) { return contact.singular(); });
  const auto shown = std::count_if(solids.begin(), solids.end(),
                                   [](const DrawnSolid& drawn) { return drawn.part != Part::kOutline; });
  return canvas.Finish(
      fmt::format("{} solids, {} contacts, {} of them singular", shown, relation.contacts.size(), singular));
}

}  // namespace tact::provers
