#include "robot/recognition/element_distance.h"

#include <algorithm>
#include <cmath>

namespace tact::recognition {
namespace {

using Eigen::Vector3d;
using joint::Transform;

double DistanceToSegment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const Vector3d along = b - a;
  const double share = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
  return (a + share * along - p).norm();
}

// The solid at the vertex, whose edges leave in these directions, lies where normal . d >= -sine.
bool LiesBeyond(const std::vector<Vector3d>& edges, const Vector3d& normal, double sine) {
  return std::all_of(edges.begin(), edges.end(), [&](const Vector3d& d) { return normal.dot(d) >= -sine; });
}

bool LiesBeyond(const std::array<Vector3d, 2>& wings, const Vector3d& normal, double sine) {
  return normal.dot(wings[0]) >= -sine && normal.dot(wings[1]) >= -sine;
}

class PairFinder {
 public:
  PairFinder(const ProximitySolid& moving, const ProximitySolid& fixed, const Transform& X_FM, double limit,
             double most_tilt)
      : moving_(moving), fixed_(fixed), X_FM_(X_FM), limit_(limit), sine_(std::sin(most_tilt)) {}

  std::vector<NearPair> Find() {
    AddVertices(moving_, fixed_, X_FM_, PointContactKind::kVertexFace);
    AddVertices(fixed_, moving_, X_FM_.Inverse(), PointContactKind::kFaceVertex);
    AddEdges();
    std::sort(pairs_.begin(), pairs_.end(),
              [](const NearPair& a, const NearPair& b) { return a.contact < b.contact; });
    return std::move(pairs_);
  }

 private:
  // Vertices of one solid near faces of the other; X is the pose of the vertices' solid in the faces'.
  void AddVertices(const ProximitySolid& vertices, const ProximitySolid& faces, const Transform& X,
                   PointContactKind kind) {
    for (size_t v = 0; v < vertices.solid().vertices.size(); ++v) {
      const Vector3d p = X * vertices.solid().vertices[v];
      for (size_t f = 0; f < faces.solid().faces.size(); ++f) {
        const auto& face = faces.solid().faces[f];
        const double gap = face.normal.dot(p) - face.offset;
        if (std::abs(gap) >= limit_) continue;
        if (!LiesBeyond(vertices.edges_at(v), X.R.transpose() * face.normal, sine_)) continue;
        const double distance = faces.DistanceToFace(f, p);
        if (distance >= limit_) continue;
        const bool is_moving = kind == PointContactKind::kVertexFace;
        pairs_.push_back({{kind, is_moving ? v : f, is_moving ? f : v, 1}, distance, gap});
      }
    }
  }

  void AddEdges() {
    for (size_t e = 0; e < moving_.solid().edges.size(); ++e) {
      if (!moving_.is_convex(e)) continue;
      const Vector3d a = X_FM_ * moving_.solid().edges[e].tail, b = X_FM_ * moving_.solid().edges[e].head;
      for (size_t g = 0; g < fixed_.solid().edges.size(); ++g) {
        if (fixed_.is_convex(g)) AddCrossing(e, a, b, g);
      }
    }
  }

  void AddCrossing(size_t e, const Vector3d& a, const Vector3d& b, size_t g) {
    const auto& [c, d] = fixed_.solid().edges[g];
    const double long_ab = (b - a).norm(), long_cd = (d - c).norm();
    const Vector3d u = (b - a) / long_ab, v = (d - c) / long_cd, cross = u.cross(v);
    const double sine = cross.norm();
    if (sine <= sine_) return;  // parallel as far as anyone can see: their ends' vertices say it
    const double gap = cross.dot(a - c) / sine;
    if (std::abs(gap) >= limit_) return;
    // Where the lines are nearest, from the tails.
    const double along_u = (c - a).cross(v).dot(cross) / (sine * sine);
    const double along_v = (c - a).cross(u).dot(cross) / (sine * sine);
    if (std::min(along_u, long_ab - along_u) < limit_ || std::min(along_v, long_cd - along_v) < limit_)
      return;
    for (const int sign : {1, -1}) {
      const Vector3d n = sign / sine * cross;
      if (!LiesBeyond(moving_.wings(e), X_FM_.R.transpose() * n, sine_) ||
          !LiesBeyond(fixed_.wings(g), -n, sine_))
        continue;
      pairs_.push_back({{PointContactKind::kEdgeEdge, e, g, sign}, std::abs(gap), sign * gap});
    }
  }

  const ProximitySolid &moving_, &fixed_;
  const Transform& X_FM_;
  double limit_, sine_;
  std::vector<NearPair> pairs_;
};

}  // namespace

double DistanceOfSegments(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d) {
  const Vector3d u = b - a, v = d - c, cross = u.cross(v);
  double nearest = std::min({DistanceToSegment(a, c, d), DistanceToSegment(b, c, d),
                             DistanceToSegment(c, a, b), DistanceToSegment(d, a, b)});
  const double square = cross.squaredNorm();
  if (square > 0) {
    const double s = (c - a).cross(v).dot(cross) / square, t = (c - a).cross(u).dot(cross) / square;
    if (s > 0 && s < 1 && t > 0 && t < 1)
      nearest = std::min(nearest, std::abs((c - a).dot(cross)) / std::sqrt(square));
  }
  return nearest;
}

ProximitySolid::ProximitySolid(const algebra::Polyhedron& solid) : solid_(ToDouble(solid)) {
  edges_at_.resize(solid_.vertices.size());
  for (size_t e = 0; e < solid.edges.size(); ++e) {
    const algebra::Edge& edge = solid.edges[e];
    const Vector3d along = (solid_.edges[e].head - solid_.edges[e].tail).normalized();
    edges_at_[edge.tail].push_back(along);
    edges_at_[edge.head].push_back(-along);
    // The left face's boundary runs tail to head, the right one's back.
    wings_.push_back(
        {solid_.faces[edge.left].normal.cross(along), along.cross(solid_.faces[edge.right].normal)});
    convex_.push_back(edge.convexity == algebra::Convexity::kConvex);
    ends_.push_back({edge.tail, edge.head});
  }
  for (const algebra::Face& face : solid.faces) loops_.push_back(face.loops);
}

bool ProximitySolid::Encloses(size_t face, const Vector3d& foot) const {
  // Seen along the axis that the plane is squarest to.
  int axis = 0;
  solid_.faces[face].normal.cwiseAbs().maxCoeff(&axis);
  const int x = (axis + 1) % 3, y = (axis + 2) % 3;
  bool inside = false;
  for (const auto& loop : loops_[face]) {
    const Vector3d* a = &solid_.vertices[loop.back()];
    for (const size_t next : loop) {
      const Vector3d* b = &solid_.vertices[next];
      if (((*a)[y] > foot[y]) != ((*b)[y] > foot[y]) &&
          foot[x] < (*a)[x] + (foot[y] - (*a)[y]) / ((*b)[y] - (*a)[y]) * ((*b)[x] - (*a)[x]))
        inside = !inside;
      a = b;
    }
  }
  return inside;
}

double ProximitySolid::DistanceToFace(size_t face, const Vector3d& p) const {
  const auto& plane = solid_.faces[face];
  const double gap = plane.normal.dot(p) - plane.offset;
  if (Encloses(face, p - gap * plane.normal)) return std::abs(gap);
  double rim = HUGE_VAL;
  for (const auto& loop : loops_[face]) {
    const Vector3d* a = &solid_.vertices[loop.back()];
    for (const size_t next : loop) {
      const Vector3d* b = &solid_.vertices[next];
      rim = std::min(rim, DistanceToSegment(p, *a, *b));
      a = b;
    }
  }
  return rim;
}

double ProximitySolid::DistanceToSurface(const Vector3d& p) const {
  double nearest = HUGE_VAL;
  for (size_t f = 0; f < solid_.faces.size(); ++f) nearest = std::min(nearest, DistanceToFace(f, p));
  return nearest;
}

double ProximitySolid::DepthOf(const Vector3d& p) const {
  // How often a ray leaves, faces crossed by it counted odd or even; its direction is parallel to no face that people draw.
  const Vector3d ray(0.5409713, 0.3762153, 0.7522179);
  bool inside = false;
  for (size_t f = 0; f < solid_.faces.size(); ++f) {
    const auto& face = solid_.faces[f];
    const double slope = face.normal.dot(ray), way = face.offset - face.normal.dot(p);
    if (slope == 0 || way / slope <= 0) continue;
    if (Encloses(f, p + way / slope * ray)) inside = !inside;
  }
  return inside ? DistanceToSurface(p) : 0;
}

std::vector<NearPair> NearPairs(const ProximitySolid& moving, const ProximitySolid& fixed,
                                const Transform& X_FM, double limit, double most_tilt) {
  return PairFinder(moving, fixed, X_FM, limit, most_tilt).Find();
}

}  // namespace tact::recognition
