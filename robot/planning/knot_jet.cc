#include "robot/planning/knot_jet.h"

namespace tact::planning {
namespace {

using Eigen::Vector3d;
using recognition::PointContactKind;

Jet Dot(const JetVector& a, const JetVector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

JetVector Cross(const JetVector& a, const JetVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

JetVector operator+(const JetVector& a, const JetVector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
JetVector operator-(const JetVector& a, const JetVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

JetVector Constant(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace

Jet Jet::Variable(int index, double v) {
  Jet jet(v);
  jet.gradient[index] = 1;
  return jet;
}

Jet operator+(const Jet& a, const Jet& b) {
  Jet sum(a.value + b.value);
  sum.gradient = a.gradient + b.gradient;
  sum.hessian = a.hessian + b.hessian;
  return sum;
}

Jet operator-(const Jet& a, const Jet& b) { return a + Jet(-1) * b; }

Jet operator*(const Jet& a, const Jet& b) {
  Jet product(a.value * b.value);
  product.gradient = a.value * b.gradient + b.value * a.gradient;
  product.hessian = a.value * b.hessian + b.value * a.hessian + a.gradient * b.gradient.transpose() +
                    b.gradient * a.gradient.transpose();
  return product;
}

KnotJets::KnotJets(const double* numbers) {
  for (int i = 0; i < 4; ++i) q[static_cast<size_t>(i)] = Jet::Variable(i, numbers[i]);
  for (int i = 0; i < 3; ++i) t[static_cast<size_t>(i)] = Jet::Variable(4 + i, numbers[4 + i]);
}

JetVector KnotJets::Rotated(const Vector3d& v) const {
  const JetVector u{q[1], q[2], q[3]}, fixed = Constant(v), across = Cross(u, fixed);
  const Jet keep = q[0] * q[0] - Dot(u, u), along = Jet(2) * Dot(u, fixed), turn = Jet(2) * q[0];
  JetVector answer;
  for (size_t i = 0; i < 3; ++i) answer[i] = keep * fixed[i] + along * u[i] + turn * across[i];
  return answer;
}

Jet GapJet(const recognition::PointContact& contact, const recognition::SolidF& moving,
           const recognition::SolidF& fixed, double size, const KnotJets& knot) {
  switch (contact.kind) {
    case PointContactKind::kVertexFace: {
      const auto& face = fixed.faces[contact.fixed];
      const JetVector at = knot.Rotated(moving.vertices[contact.moving] / size) + knot.t;
      return Dot(Constant(face.normal), at) - Jet(face.offset / size);
    }
    case PointContactKind::kFaceVertex: {
      const auto& face = moving.faces[contact.moving];
      const JetVector away = Constant(fixed.vertices[contact.fixed] / size) - knot.t;
      return Dot(knot.Rotated(face.normal), away) - Jet(face.offset / size);
    }
    default: {
      const auto& m = moving.edges[contact.moving];
      const auto& f = fixed.edges[contact.fixed];
      const JetVector e = knot.Rotated((m.head - m.tail).normalized());
      const JetVector apart = knot.Rotated(m.tail / size) + knot.t - Constant(f.tail / size);
      const JetVector g = Constant((f.head - f.tail).normalized());
      return Jet(contact.orientation) * Dot(Cross(e, g), apart);
    }
  }
}

}  // namespace tact::planning
