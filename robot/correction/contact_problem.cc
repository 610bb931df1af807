#include "robot/correction/contact_problem.h"

#include <algorithm>
#include <cmath>

namespace tact::correction {
namespace {

using Eigen::Vector3d;
using joint::Transform;
using recognition::PointContact;
using recognition::PointContactKind;

constexpr double kSameDirection = 1e-9;  // sine below which two lines are parallel, or two planes the same

Solid SolidOf(const algebra::Polyhedron& polyhedron) {
  Solid solid{recognition::ToDouble(polyhedron), ConvexPiecesOf(polyhedron), {}};
  for (const auto& face : solid.elements.faces) {
    solid.face_parts.emplace_back();
    for (const ConvexPiece& piece : solid.pieces) {
      for (size_t i = 0; i < piece.faces.size(); ++i) {
        const HalfSpace& h = piece.faces[i];
        if (h.normal.dot(face.normal) < 0 || h.normal.cross(face.normal).norm() > kSameDirection) continue;
        if (std::abs(h.offset - face.offset) > 100 * kThin * (piece.radius + std::abs(face.offset))) continue;
        solid.face_parts.back().push_back(SidesOf(piece, i));
      }
    }
  }
  return solid;
}

// How far inside of all sides, negative outside.
double Inside(const std::vector<HalfSpace>& sides, const Vector3d& p) {
  double inside = HUGE_VAL;
  for (const HalfSpace& h : sides) inside = std::min(inside, h.offset - h.normal.dot(p));
  return inside;
}

double Value(const Feature& feature, const Posed<double>& X) { return ValueOf(feature, X); }

}  // namespace

std::string ToString(Outcome outcome) {
  switch (outcome) {
    case Outcome::kCorrected:
      return "corrected";
    case Outcome::kDiverged:
      return "diverged";
    case Outcome::kNotConverged:
      return "not converged";
    case Outcome::kGapRemains:
      return "a gap remains";
    case Outcome::kElementsApart:
      return "elements no longer meet";
    case Outcome::kPenetrates:
      return "penetrates";
    case Outcome::kNoRealisation:
      return "needs a realisation";
  }
  return "";
}

Models ModelsOf(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed) {
  Models models{SolidOf(moving), SolidOf(fixed), 0};
  for (const Vector3d& v : models.moving.elements.vertices) {
    models.size = std::max(models.size, v.norm());
    for (const Vector3d& w : models.moving.elements.vertices)
      models.size = std::max(models.size, (v - w).norm());
  }
  return models;
}

Feature GapFeature(const PointContact& contact, const Models& models) {
  const auto &m = models.moving.elements, &f = models.fixed.elements;
  switch (contact.kind) {
    case PointContactKind::kVertexFace: {
      const auto& face = f.faces[contact.fixed];
      return {FeatureKind::kVertexFace,
              m.vertices[contact.moving],
              Vector3d::Zero(),
              face.offset * face.normal,
              face.normal,
              1};
    }
    case PointContactKind::kFaceVertex: {
      const auto& face = m.faces[contact.moving];
      return {FeatureKind::kFaceVertex,  face.offset * face.normal, face.normal,
              f.vertices[contact.fixed], Vector3d::Zero(),          1};
    }
    default: {
      const auto &e = m.edges[contact.moving], &g = f.edges[contact.fixed];
      return {FeatureKind::kEdgeEdge,         e.tail,
              (e.head - e.tail).normalized(), g.tail,
              (g.head - g.tail).normalized(), static_cast<double>(contact.orientation)};
    }
  }
}

std::vector<Feature> WithinFeatures(const PointContact& contact, const Models& models,
                                    const Transform& X_FM) {
  const auto &m = models.moving.elements, &f = models.fixed.elements;
  std::vector<Feature> features;
  if (contact.kind == PointContactKind::kEdgeEdge) {
    const auto &e = m.edges[contact.moving], &g = f.edges[contact.fixed];
    Feature feature = GapFeature(contact, models);
    const double sine = (X_FM.R * feature.moving_direction).cross(feature.fixed_direction).norm();
    const double factor = 1 / std::max(sine * sine, kSameDirection);
    for (const FeatureKind kind : {FeatureKind::kAlongMoving, FeatureKind::kAlongFixed}) {
      for (const bool head : {false, true}) {
        feature.kind = kind;
        feature.moving_point = kind == FeatureKind::kAlongMoving && head ? e.head : e.tail;
        feature.fixed_point = kind == FeatureKind::kAlongFixed && head ? g.head : g.tail;
        feature.factor = head ? factor : -factor;
        features.push_back(feature);
      }
    }
    return features;
  }
  const bool face_fixed = contact.kind == PointContactKind::kVertexFace;
  const auto& parts =
      face_fixed ? models.fixed.face_parts[contact.fixed] : models.moving.face_parts[contact.moving];
  const Vector3d at =
      face_fixed ? X_FM * m.vertices[contact.moving] : X_FM.Inverse() * f.vertices[contact.fixed];
  const auto best = std::max_element(parts.begin(), parts.end(), [&](const auto& a, const auto& b) {
    return Inside(a, at) < Inside(b, at);
  });
  if (best == parts.end()) return features;
  for (const HalfSpace& side : *best) {
    const Vector3d on = side.offset * side.normal;
    if (face_fixed)
      features.push_back(
          {FeatureKind::kVertexFace, m.vertices[contact.moving], Vector3d::Zero(), on, -side.normal, 1});
    else
      features.push_back(
          {FeatureKind::kFaceVertex, on, -side.normal, f.vertices[contact.fixed], Vector3d::Zero(), 1});
  }
  return features;
}

double BallGap(const ConvexPiece& moving, const ConvexPiece& fixed, const Transform& X_FM) {
  return (X_FM * moving.middle - fixed.middle).norm() - moving.radius - fixed.radius;
}

Separation Widest(const ConvexPiece& moving, const ConvexPiece& fixed, const Transform& X_FM) {
  constexpr size_t kMost = 64;
  std::array<Vector3d, kMost> few;
  std::vector<Vector3d> many;
  Vector3d* posed = few.data();
  if (moving.vertices.size() > kMost) many.resize(moving.vertices.size()), posed = many.data();
  const size_t count = moving.vertices.size();
  for (size_t i = 0; i < count; ++i) posed[i] = X_FM * moving.vertices[i];
  const auto lowest_moving = [&](const Vector3d& n) {
    double low = HUGE_VAL;
    for (size_t i = 0; i < count; ++i) low = std::min(low, n.dot(posed[i]));
    return low;
  };
  const auto highest_fixed = [&](const Vector3d& n) {
    double high = -HUGE_VAL;
    for (const Vector3d& v : fixed.vertices) high = std::max(high, n.dot(v));
    return high;
  };
  Separation widest;
  widest.gap = -HUGE_VAL;
  for (size_t i = 0; i < fixed.faces.size(); ++i) {
    const double gap = lowest_moving(fixed.faces[i].normal) - fixed.faces[i].offset;
    if (gap > widest.gap) widest = {gap, FeatureKind::kVertexFace, i, 0, 1};
  }
  for (size_t i = 0; i < moving.faces.size(); ++i) {
    const Vector3d n = -(X_FM.R * moving.faces[i].normal);
    const double gap = n.dot(X_FM.p) - moving.faces[i].offset - highest_fixed(n);
    if (gap > widest.gap) widest = {gap, FeatureKind::kFaceVertex, i, 0, 1};
  }
  for (size_t i = 0; i < moving.directions.size(); ++i) {
    const Vector3d e = X_FM.R * moving.directions[i];
    for (size_t j = 0; j < fixed.directions.size(); ++j) {
      const Vector3d cross = e.cross(fixed.directions[j]);
      const double sine = cross.norm();
      if (sine < kSameDirection) continue;
      for (const double sign : {1.0, -1.0}) {
        const Vector3d n = sign / sine * cross;
        const double gap = lowest_moving(n) - highest_fixed(n);
        // A face's plane is preferred to one that is no wider.
        if (gap > widest.gap + kSameDirection * fixed.radius)
          widest = {gap, FeatureKind::kEdgeEdge, i, j, sign};
      }
    }
  }
  return widest;
}

std::vector<Feature> SeparationFeatures(const ConvexPiece& moving, const ConvexPiece& fixed,
                                        const Transform& X_FM, const Separation& separation, double near) {
  std::vector<Feature> features;
  const Posed<double> X = PosedAt(X_FM, Vector3d::Zero());
  const auto add = [&](const Feature& feature) {
    if (Value(feature, X) <= separation.gap + near) features.push_back(feature);
  };
  if (separation.kind == FeatureKind::kVertexFace) {
    const HalfSpace& h = fixed.faces[separation.first];
    for (const Vector3d& v : moving.vertices)
      add({FeatureKind::kVertexFace, v, Vector3d::Zero(), h.offset * h.normal, h.normal, 1});
  } else if (separation.kind == FeatureKind::kFaceVertex) {
    const HalfSpace& h = moving.faces[separation.first];
    for (const Vector3d& v : fixed.vertices)
      add({FeatureKind::kFaceVertex, h.offset * h.normal, h.normal, v, Vector3d::Zero(), 1});
  } else {
    const Vector3d &e = moving.directions[separation.first], &g = fixed.directions[separation.second];
    const double sine = (X_FM.R * e).cross(g).norm();
    // The corners that the plane meets, one of each solid.
    const Vector3d n = separation.sign / sine * (X_FM.R * e).cross(g);
    const auto& lowest =
        *std::min_element(moving.vertices.begin(), moving.vertices.end(),
                          [&](auto& a, auto& b) { return n.dot(X_FM.R * a) < n.dot(X_FM.R * b); });
    const auto& highest = *std::max_element(fixed.vertices.begin(), fixed.vertices.end(),
                                            [&](auto& a, auto& b) { return n.dot(a) < n.dot(b); });
    features.push_back({FeatureKind::kEdgeEdge, lowest, e, highest, g, separation.sign / sine});
  }
  return features;
}

Outcome Judge(const Models& models, const std::vector<PointContact>& contacts, const Transform& X_FM,
              double tolerance) {
  for (const PointContact& contact : contacts) {
    const double gap = GapOf(contact, models.moving.elements, models.fixed.elements, X_FM).gap;
    if (!(std::abs(gap) <= tolerance)) return Outcome::kGapRemains;
  }
  const Posed<double> X = PosedAt(X_FM, Vector3d::Zero());
  for (const PointContact& contact : contacts)
    for (const Feature& feature : WithinFeatures(contact, models, X_FM))
      if (Value(feature, X) < -tolerance) return Outcome::kElementsApart;
  for (const ConvexPiece& a : models.moving.pieces)
    for (const ConvexPiece& b : models.fixed.pieces)
      if (BallGap(a, b, X_FM) < 0 && Widest(a, b, X_FM).gap < -tolerance) return Outcome::kPenetrates;
  return Outcome::kCorrected;
}

Outcome Judge(const Models& models, const std::vector<PointContact>& contacts, const Transform& X_FM) {
  return Judge(models, contacts, X_FM, kTouching * models.size);
}

}  // namespace tact::correction
