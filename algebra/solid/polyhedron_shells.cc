// How shells lie to one another. Shells that touch are compared face by face: a face is cut along all it
// meets of the other shell, and a point of each piece is located. Shells that do not touch are compared by
// one point each.
#include <algorithm>
#include <map>
#include <set>

#include "algebra/solid/box_sweep.h"
#include "algebra/solid/soup_mesh.h"

namespace tact::algebra {
namespace {

struct Segment {
  Vector3 a, b;
};

// For a face, the faces of one other shell that it meets.
using Contacts = std::map<std::pair<size_t, size_t>, std::set<size_t>>;  // (face, other shell) -> faces

class ShellCheck {
 public:
  explicit ShellCheck(const MergedFaces& merged) : merged_(merged), solid_(merged.solid) {}

  void Run() {
    Measure();
    if (solid_.shells > 1) {
      FindContacts();
      for (const auto& [key, faces] : contacts_) CheckTouch(key.first, key.second, faces);
    }
    for (size_t shell = 0; shell < solid_.shells; ++shell) CheckNesting(shell);
  }

 private:
  void Measure() {
    first_face_.assign(solid_.shells, SoupDefect::kNone);
    face_boxes_.resize(solid_.faces.size());
    shell_boxes_.resize(solid_.shells);
    std::vector<Rational> volumes(solid_.shells);
    for (size_t f = 0; f < solid_.faces.size(); ++f) {
      const size_t shell = solid_.faces[f].shell;
      regions_.push_back(RegionOf(solid_, solid_.faces[f]));
      first_face_[shell] = std::min(first_face_[shell], f);
      volumes[shell] += SixfoldVolumeUnder(regions_[f]);
      for (const Vector3* corner : regions_[f].loops[0]) face_boxes_[f].Add(*corner);
      shell_boxes_[shell].Add(face_boxes_[f]);
    }
    for (const Rational& volume : volumes) is_cavity_.push_back(volume.sign() < 0);
  }

  void FindContacts() {
    std::vector<BoundingBox> edge_boxes;
    for (const Edge& edge : solid_.edges) {
      edge_boxes.emplace_back().Add(Point(edge.tail));
      edge_boxes.back().Add(Point(edge.head));
    }
    SweepOverlaps(edge_boxes, face_boxes_, [&](size_t e, size_t f) {
      const Edge& edge = solid_.edges[e];
      const size_t shell = solid_.faces[edge.left].shell, other = solid_.faces[f].shell;
      if (shell == other || !Meets(regions_[f], Point(edge.tail), Point(edge.head))) return true;
      for (const size_t side : {edge.left, edge.right}) {
        contacts_[{side, other}].insert(f);
        contacts_[{f, shell}].insert(side);
      }
      touching_.insert(std::minmax(shell, other));
      return true;
    });
  }

  // A piece of a face must be outside a touching solid, or inside a touching cavity, or lie on a face that
  // looks the other way.
  void CheckTouch(size_t face, size_t other, const std::set<size_t>& met) const {
    const size_t shell = solid_.faces[face].shell;
    if (is_cavity_[shell]) RefuseOutsideContact(shell, other);
    if (is_cavity_[other]) RefuseOutsideContact(other, shell);
    for (const Vector3& sample : SamplePieces(regions_[face], met)) {
      bool on_boundary = false;
      for (const size_t f : met) {
        if (regions_[f].Height(sample).sign() != 0) continue;
        if (LocateInPlane(regions_[f], sample) == Side::kOutside) continue;
        on_boundary = true;
        if (regions_[f].normal == regions_[face].normal) RefuseOverlap(shell, other, sample);
      }
      if (!on_boundary && (WindingOf(other, sample) != 0) != is_cavity_[other]) {
        RefuseOverlap(shell, other, sample);
      }
    }
  }

  // A cavity may be touched from within only.
  void RefuseOutsideContact(size_t cavity, size_t shell) const {
    for (const Vertex& vertex : solid_.vertices) {
      if (vertex.shell != shell || WindingOf(cavity, vertex.point) != 0 || IsOn(cavity, vertex.point))
        continue;
      Refuse("its shell has negative volume and touches the shell of " + FirstText(shell) +
                 ", expected a cavity strictly inside one solid; move the cavity off the surface, or reverse "
                 "the corners of every polygon of this shell if it is meant to be a body",
             FirstPolygon(cavity));
    }
  }

  bool IsOn(size_t shell, const Vector3& point) const {
    for (size_t f = 0; f < regions_.size(); ++f) {
      if (solid_.faces[f].shell == shell && regions_[f].Height(point).sign() == 0 &&
          LocateInPlane(regions_[f], point) != Side::kOutside) {
        return true;
      }
    }
    return false;
  }

  // One point inside every piece, at least, into which a region is cut by faces that it meets.
  std::vector<Vector3> SamplePieces(const PlanarRegion& region, const std::set<size_t>& met) const {
    std::vector<Segment> cuts;
    AddBoundary(region, &cuts);
    for (const size_t f : met) AddCut(region, regions_[f], &cuts);
    std::vector<Vector3> samples;
    for (const Segment& cut : cuts) {
      std::vector<Rational> stops{0, 1};
      for (const Segment& other : cuts) AddStops(region.axes, cut, other, &stops);
      std::sort(stops.begin(), stops.end());
      stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
      for (size_t i = 0; i + 1 < stops.size(); ++i) {
        const Vector3 middle = cut.a + Rational(1, 2) * (stops[i] + stops[i + 1]) * (cut.b - cut.a);
        const Vector3 across = Cross(region.normal, cut.b - cut.a);
        for (const Vector3& way : {across, -across}) {
          const auto sample = Beside(region.axes, middle, way, cuts);
          if (sample && LocateInPlane(region, *sample) == Side::kInside) samples.push_back(*sample);
        }
      }
    }
    std::sort(samples.begin(), samples.end());
    samples.erase(std::unique(samples.begin(), samples.end()), samples.end());
    return samples;
  }

  static void AddBoundary(const PlanarRegion& region, std::vector<Segment>* cuts) {
    for (const auto& loop : region.loops) {
      for (size_t i = 0; i < loop.size(); ++i) cuts->push_back({*loop[i], *loop[(i + 1) % loop.size()]});
    }
  }

  // Coplanar faces cut along their boundary, others along the segment that spans all they share with the
  // plane.
  static void AddCut(const PlanarRegion& region, const PlanarRegion& other, std::vector<Segment>* cuts) {
    const Vector3 line = Cross(region.normal, other.normal);
    if (line.IsZero()) return AddBoundary(other, cuts);
    std::vector<std::pair<Rational, Vector3>> crossings;
    std::vector<Segment> edges;
    AddBoundary(other, &edges);
    for (const Segment& edge : edges) {
      const Rational at_a = region.Height(edge.a), at_b = region.Height(edge.b);
      if (at_a.sign() == 0) crossings.emplace_back(Dot(line, edge.a), edge.a);
      if (at_a.sign() * at_b.sign() >= 0) continue;
      const Vector3 p = edge.a + at_a / (at_a - at_b) * (edge.b - edge.a);
      crossings.emplace_back(Dot(line, p), p);
    }
    const auto [low, high] = std::minmax_element(crossings.begin(), crossings.end());
    if (low != crossings.end() && low->second != high->second) cuts->push_back({low->second, high->second});
  }

  // Where another cut meets this one, as fractions of it.
  static void AddStops(Axes axes, const Segment& cut, const Segment& other, std::vector<Rational>* stops) {
    const int length_axis = cut.a[axes.u] != cut.b[axes.u] ? axes.u : axes.v;
    const auto fraction = [&](const Vector3& p) {
      return (p[length_axis] - cut.a[length_axis]) / (cut.b[length_axis] - cut.a[length_axis]);
    };
    const auto add = [&](const Vector3& p) {
      const Rational f = fraction(p);
      if (f.sign() > 0 && f < Rational(1)) stops->push_back(f);
    };
    if (const auto p = UnsharedPoint(axes, cut.a, cut.b, other.a, other.b)) add(*p);
    for (const Vector3* end : {&other.a, &other.b}) {
      if (Orientation(axes, cut.a, cut.b, *end) == 0) add(*end);
    }
  }

  // A point so near to middle, on the side of way, that no cut is between; nullopt if no cut is on that side.
  static std::optional<Vector3> Beside(Axes axes, const Vector3& middle, const Vector3& way,
                                       const std::vector<Segment>& cuts) {
    std::optional<Rational> nearest;
    for (const Segment& cut : cuts) {
      const Vector3 along = cut.b - cut.a, from = cut.a - middle;
      const Rational turn = way[axes.u] * along[axes.v] - way[axes.v] * along[axes.u];
      if (turn.sign() == 0) continue;
      const Rational reach = (from[axes.u] * along[axes.v] - from[axes.v] * along[axes.u]) / turn;
      const Rational place = (from[axes.u] * way[axes.v] - from[axes.v] * way[axes.u]) / turn;
      if (reach.sign() <= 0 || place.sign() < 0 || place > Rational(1)) continue;
      if (!nearest || reach < *nearest) nearest = reach;
    }
    if (!nearest) return std::nullopt;
    return middle + Rational(1, 2) * *nearest * way;
  }

  // How the shells that do not touch this one wind around it; a cavity touched from within counts too.
  void CheckNesting(size_t shell) const {
    const Vector3& point = Point(solid_.faces[first_face_[shell]].loops[0][0]);
    BoundingBox point_box;
    point_box.Add(point);
    std::vector<bool> counts(solid_.shells);
    int winding = 0;
    for (size_t other = 0; other < solid_.shells; ++other) {
      if (other == shell || !shell_boxes_[other].Overlaps(point_box)) continue;
      const bool touches = touching_.contains(std::minmax(shell, other));
      if (touches && is_cavity_[other]) --winding;
      counts[other] = !touches;
    }
    if (std::find(counts.begin(), counts.end(), true) != counts.end()) {
      winding += Winding(solid_, point, counts);
    }
    if (winding == (is_cavity_[shell] ? 1 : 0)) return;
    if (is_cavity_[shell] && winding <= 0) {
      Refuse(
          "its shell has negative volume and is not inside a solid, so it is inverted: its normals point "
          "inwards, seen at " +
              PointText(point) + "; reverse the corners of every polygon of this shell",
          FirstPolygon(shell));
    }
    Refuse("its shell lies inside another solid, at " + PointText(point) +
               ", so the two overlap; remove one, or reverse the inner shell if it is meant to be a cavity",
           FirstPolygon(shell));
  }

  [[noreturn]] void RefuseOverlap(size_t shell, size_t other, const Vector3& point) const {
    Refuse("its shell and the shell of " + FirstText(other) + " overlap near " + PointText(point) +
               ", expected shells that touch at most; unite the two bodies or move them apart",
           FirstPolygon(shell));
  }

  int WindingOf(size_t shell, const Vector3& point) const {
    std::vector<bool> counts(solid_.shells);
    counts[shell] = true;
    return Winding(solid_, point, counts);
  }

  const Vector3& Point(size_t vertex) const { return solid_.vertices[vertex].point; }
  size_t FirstPolygon(size_t shell) const { return merged_.first_polygon[first_face_[shell]]; }
  std::string FirstText(size_t shell) const { return PolygonText(FirstPolygon(shell)); }

  const MergedFaces& merged_;
  const Polyhedron& solid_;
  std::vector<PlanarRegion> regions_;  // of each face
  std::vector<BoundingBox> face_boxes_, shell_boxes_;
  std::vector<size_t> first_face_;  // of each shell
  std::vector<bool> is_cavity_;     // of each shell: negative volume
  Contacts contacts_;
  std::set<std::pair<size_t, size_t>> touching_;  // pairs of shells
};

}  // namespace

void RefuseBadShells(const MergedFaces& merged) { ShellCheck(merged).Run(); }

}  // namespace tact::algebra
