#include "robot/correction/linear_correction.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>

#include "algebra/error.h"

namespace tact::correction {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using joint::Transform;
using recognition::PointContact;
using recognition::PointContactKind;

struct Linearised {
  MatrixXd rows;  // [ (at - p) x n / size | n ]
  Eigen::VectorXd gaps;
  std::vector<Vector3d> at;
};

Linearised Linearise(const Models& models, const std::vector<PointContact>& contacts, const Transform& X) {
  Linearised all{MatrixXd(static_cast<Index>(contacts.size()), 6),
                 Eigen::VectorXd(static_cast<Index>(contacts.size())),
                 {}};
  for (Index i = 0; i < all.gaps.size(); ++i) {
    const recognition::Gap gap =
        GapOf(contacts[static_cast<size_t>(i)], models.moving.elements, models.fixed.elements, X);
    const Vector3d n = gap.row.tail<3>();
    all.rows.row(i) << (gap.at - X.p).cross(n).transpose() / models.size, n.transpose();
    all.gaps[i] = gap.gap;
    all.at.push_back(gap.at);
  }
  return all;
}

// The turn beta about a after which a matrix is nearest to the identity: of R(a, beta) Q the trace is
// cos beta (tr Q - a'Qa) - sin beta a.v + a'Qa, v the vector of Q's skew part, doubled.
double BestTurn(const Vector3d& a, const Matrix3d& Q) {
  const Vector3d v(Q(2, 1) - Q(1, 2), Q(0, 2) - Q(2, 0), Q(1, 0) - Q(0, 1));
  return std::atan2(-a.dot(v), Q.trace() - a.dot(Q * a));
}

Matrix3d Turn(const Vector3d& axis, double angle) {
  return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

// An edge along `edge` in M on a face with normal n in F, or, with the roles of the solids swapped, a face on an edge:
// the least turn about z after which fixed . (R moving) = 0.
std::optional<double> TurnUntilUpright(const Vector3d& z, const Vector3d& fixed, const Vector3d& moving) {
  const double level = fixed.dot(moving), rate = fixed.dot(z.cross(moving));
  if (std::hypot(level, rate) == 0) return std::nullopt;
  double angle = -std::atan2(level, rate);
  if (angle > M_PI / 2) angle -= M_PI;
  if (angle < -M_PI / 2) angle += M_PI;
  return angle;
}

// Of contacts in one plane, along one line: what Case 4 turns by, if the plane is a face of one solid.
std::optional<Matrix3d> EdgeInFace(const Models& models, const Relation& relation, const Transform& X_FM) {
  const Transform& X_e = *relation.realisation;
  const Linearised there = Linearise(models, relation.contacts, X_e);
  Vector3d along = Vector3d::Zero();
  for (const Vector3d& p : there.at)
    if ((p - there.at[0]).norm() > along.norm()) along = p - there.at[0];
  if (along.norm() < kTouching * models.size) return std::nullopt;
  const Vector3d l = along.normalized(), n = there.rows.row(0).tail<3>();
  for (const Vector3d& p : there.at)
    if ((p - there.at[0]).cross(l).norm() > kTouching * models.size) return std::nullopt;
  const Vector3d z = l.cross(n).normalized();
  const Matrix3d carried = X_FM.R * X_e.R.transpose();  // directions fixed in M, from there to here
  for (const PointContact& contact : relation.contacts) {
    std::optional<double> angle;
    if (contact.kind == PointContactKind::kVertexFace) angle = TurnUntilUpright(z, n, carried * l);
    if (contact.kind == PointContactKind::kFaceVertex) angle = TurnUntilUpright(z, l, carried * n);
    if (angle) return Matrix3d(Turn(z, *angle) * X_FM.R);
  }
  return std::nullopt;
}

}  // namespace

Ranks RanksAt(const Models& models, const std::vector<PointContact>& contacts, const Transform& X_FM) {
  Ranks ranks;
  ranks.axes = Matrix3d::Identity();
  if (contacts.empty()) return ranks;
  const Linearised here = Linearise(models, contacts, X_FM);
  Eigen::JacobiSVD<MatrixXd> all(here.rows, Eigen::ComputeFullV);
  all.setThreshold(kRank);
  ranks.all = static_cast<int>(all.rank());
  Eigen::JacobiSVD<MatrixXd> translation(here.rows.rightCols<3>());
  translation.setThreshold(kRank);
  ranks.translation = static_cast<int>(translation.rank());
  ranks.rotation = ranks.all - ranks.translation;
  const Index free = 3 - ranks.rotation;
  ranks.axes = MatrixXd(3, free);
  if (free == 0) return ranks;
  const MatrixXd motions = all.matrixV().rightCols(6 - ranks.all);
  const Eigen::JacobiSVD<MatrixXd> turns(motions.topRows<3>(), Eigen::ComputeFullU);
  ranks.axes = turns.matrixU().leftCols(free);
  return ranks;
}

Matrix3d LinearOrientation(const Models& models, const Relation& relation, const Transform& X_FM) {
  if (!relation.realisation) throw PreconditionError("linear correction: the relation needs a realisation");
  const Transform& X_e = *relation.realisation;
  const Ranks ranks = RanksAt(models, relation.contacts, X_e);
  if (ranks.rotation == 0) return X_FM.R;
  if (ranks.rotation == 3) return X_e.R;
  const Matrix3d Q = X_e.R * X_FM.R.transpose();
  if (ranks.rotation == 2) {
    const Vector3d a = ranks.axes.col(0);
    return Turn(a, BestTurn(a, Q)) * X_e.R;
  }
  if (ranks.translation == 1) {
    if (const auto R = EdgeInFace(models, relation, X_FM)) return *R;
  }
  // (A.22): R_z(alpha) = R(m, beta) Q with m across z, so alpha is the twist of Q about z.
  const Vector3d a = ranks.axes.col(0), b = ranks.axes.col(1), z = a.cross(b);
  return Turn(z, -BestTurn(z, Q)) * X_FM.R;
}

LinearAnswer CorrectLinearly(const Models& models, const Relation& relation, const Transform& X_FM) {
  LinearAnswer answer{X_FM, Outcome::kNoRealisation};
  if (!relation.realisation) return answer;
  if (!relation.contacts.empty()) {
    answer.X_FM.R = LinearOrientation(models, relation, X_FM);
    const Linearised here = Linearise(models, relation.contacts, answer.X_FM);
    Eigen::JacobiSVD<MatrixXd> svd(here.rows.rightCols<3>(), Eigen::ComputeThinU | Eigen::ComputeThinV);
    svd.setThreshold(kRank);
    answer.X_FM.p -= svd.solve(here.gaps);
  }
  answer.outcome = Judge(models, relation.contacts, answer.X_FM);
  return answer;
}

}  // namespace tact::correction
