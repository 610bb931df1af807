#include "robot/joint/thesis_estimator.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "algebra/error.h"
#include "robot/joint/least_squares.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Poses = std::span<const Transform>;

// A direction and its derivatives by inclination and azimuth.
struct DirectionJet {
  Vector3d l, by_inclination, by_azimuth;
};

DirectionJet DirectionJetAt(double inclination, double azimuth) {
  const double s = std::sin(inclination), c = std::cos(inclination);
  const double sa = std::sin(azimuth), ca = std::cos(azimuth);
  return {{s * ca, s * sa, c}, {c * ca, c * sa, -s}, {-s * sa, s * ca, 0}};
}

Eigen::Vector2d SphericalOf(const Vector3d& l) {
  return {std::acos(std::clamp(l.z(), -1.0, 1.0)), std::atan2(l.y(), l.x())};
}

Matrix3d Turn(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vector3d::Unit(axis)).toRotationMatrix();
}

// A rotation and its derivatives by its three angles.
struct RotationJet {
  Matrix3d R;
  std::array<Matrix3d, 3> by;
};

RotationJet RotationJetAt(const Vector3d& angles) {
  const Matrix3d Rz = Turn(2, angles[0]), Ry = Turn(1, angles[1]), Rx = Turn(0, angles[2]);
  const auto cross = [](int axis, const Matrix3d& R) {  // [e]x R
    Matrix3d result;
    for (int i = 0; i < 3; ++i) result.col(i) = Vector3d::Unit(axis).cross(R.col(i));
    return result;
  };
  const Matrix3d Ryx = Ry * Rx, R = Rz * Ryx;
  return {R, {cross(2, R), Rz * cross(1, Ryx), Rz * Ry * cross(0, Rx)}};
}

Matrix3d SumOfOrientations(Poses poses) {
  Matrix3d sum = Matrix3d::Zero();
  for (const Transform& X_BA : poses) sum += X_BA.R;
  return sum;
}

// (4.6): sum of (3 - Tr(R_i Theta^T)) / 2.
CgMinimum MinimizePrismatic(Poses poses, const CgOptions& options) {
  const Matrix3d sum = SumOfOrientations(poses);
  const Objective objective = [&](const Unknowns& x, Unknowns* gradient) {
    const RotationJet jet = RotationJetAt(x);
    for (int i = 0; i < 3; ++i) (*gradient)[i] = -sum.cwiseProduct(jet.by[i]).sum() / 2;
    return (3 * static_cast<double>(poses.size()) - sum.cwiseProduct(jet.R).sum()) / 2;
  };
  return MinimizeByConjugateGradient(objective, AnglesOf(poses.front().R), options);
}

// (4.16): sum of 1 - l_B . R_i l_A.
CgMinimum MinimizeRevolute(Poses poses, const CgOptions& options) {
  const Matrix3d sum = SumOfOrientations(poses);
  const Objective objective = [&](const Unknowns& x, Unknowns* gradient) {
    const DirectionJet A = DirectionJetAt(x[0], x[1]), B = DirectionJetAt(x[2], x[3]);
    const Vector3d to_B = sum * A.l, to_A = sum.transpose() * B.l;
    *gradient << -to_A.dot(A.by_inclination), -to_A.dot(A.by_azimuth), -to_B.dot(B.by_inclination),
        -to_B.dot(B.by_azimuth);
    return static_cast<double>(poses.size()) - B.l.dot(to_B);
  };
  const AxisPair guess = MethodA(poses);
  Unknowns start(4);
  start << SphericalOf(guess.l_A), SphericalOf(guess.l_B);
  return MinimizeByConjugateGradient(objective, start, options);
}

// (4.38): sum of (z . Theta_LB^T R_i Theta_LA y)^2, a quadratic form in the matrix z-axis times y-axis.
CgMinimum MinimizeTwoAxis(Poses poses, const CgOptions& options) {
  Matrix9 moment = Matrix9::Zero();
  for (const Transform& X_BA : poses) {
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> r(X_BA.R.data());
    moment.noalias() += r * r.transpose();
  }
  const Objective objective = [&](const Unknowns& x, Unknowns* gradient) {
    const RotationJet A = RotationJetAt(x.head<3>()), B = RotationJetAt(x.tail<3>());
    const Vector3d v = A.R.col(1), u = B.R.col(2);
    const Matrix3d product = u * v.transpose();
    const Eigen::Map<const Eigen::Matrix<double, 9, 1>> w(product.data());
    Matrix3d slope;
    Eigen::Map<Eigen::Matrix<double, 9, 1>> slope_vector(slope.data());
    slope_vector.noalias() = moment * w;
    for (int i = 0; i < 3; ++i) {
      (*gradient)[i] = 2 * u.dot(slope * A.by[i].col(1));
      (*gradient)[3 + i] = 2 * B.by[i].col(2).dot(slope * v);
    }
    return w.dot(slope_vector);
  };
  return MinimizeByConjugateGradient(objective, Unknowns(Unknowns::Zero(6)), options);
}

// The principal component of the locations, (4.7).
Vector3d PrincipalDirection(Poses poses, Vector3d* mean) {
  mean->setZero();
  for (const Transform& X_BA : poses) *mean += X_BA.p;
  *mean /= static_cast<double>(poses.size());
  Matrix3d covariance = Matrix3d::Zero();
  for (const Transform& X_BA : poses) covariance.noalias() += (X_BA.p - *mean) * (X_BA.p - *mean).transpose();
  return EigenOf(covariance).vectors.col(2);
}

// (4.18) and, with angles, (4.24): the normal equations of A_i = (-R_i | I | angle_i l_B), whose sums come apart.
Joint WithCenters(Joint joint, std::span<const Matrix3d> corrected, Poses poses,
                  std::span<const double> angles) {
  const int unknowns = angles.empty() ? 6 : 7;
  const Vector3d l_B = joint.X_BJ.R.col(2);
  SmallMatrix normal = SmallMatrix::Zero(unknowns, unknowns);
  SmallVector right = SmallVector::Zero(unknowns);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector3d l_A_turned = corrected[i].transpose() * l_B, p_A = corrected[i].transpose() * poses[i].p;
    normal.topLeftCorner<3, 3>() += Matrix3d::Identity();
    normal.block<3, 3>(3, 3) += Matrix3d::Identity();
    normal.block<3, 3>(3, 0) -= corrected[i];
    normal.block<3, 3>(0, 3) -= corrected[i].transpose();
    right.head<3>() -= p_A;
    right.segment<3>(3) += poses[i].p;
    if (angles.empty()) continue;
    normal.col(6).head<3>() -= angles[i] * l_A_turned;
    normal.col(6).segment<3>(3) += angles[i] * l_B;
    normal(6, 6) += angles[i] * angles[i];
    right[6] += angles[i] * l_B.dot(poses[i].p);
  }
  if (!angles.empty()) normal.row(6).head<6>() = normal.col(6).head<6>().transpose();
  const SmallVector solution = SolveSymmetric(normal, right);
  joint.X_AJ.p = solution.head<3>();
  joint.X_BJ.p = solution.segment<3>(3);
  if (!angles.empty()) joint.pitch = solution[6];
  return joint;
}

Joint OnAxis(JointType type, Poses poses, const AxisPair& axes) {
  Joint joint{type, {FrameWithZ(axes.l_B), Vector3d::Zero()}, {}, 0, 0};
  std::vector<Matrix3d> corrected;
  corrected.reserve(poses.size());
  for (const Transform& X_BA : poses) corrected.push_back(CorrectedOrientation(X_BA.R, axes));
  joint.X_AJ.R = corrected.front().transpose() * joint.X_BJ.R;
  std::vector<double> angles;
  if (type == JointType::kScrew) {
    const Vector3d x_A = joint.X_AJ.R.col(0);
    for (const Matrix3d& R : corrected) {
      const Vector3d x_B = R * x_A;
      angles.push_back(std::atan2(x_B.dot(joint.X_BJ.R.col(1)), x_B.dot(joint.X_BJ.R.col(0))));
    }
    Unwrap(angles);
  }
  return WithCenters(joint, corrected, poses, angles);
}

Joint Prismatic(Poses poses, const Matrix3d& R_BA) {
  Vector3d mean;
  const Transform X_BJ{FrameWithZ(PrincipalDirection(poses, &mean)), mean};
  return {JointType::kPrismatic, X_BJ, {R_BA.transpose() * X_BJ.R, Vector3d::Zero()}, 0, 0};
}

}  // namespace

Vector3d DirectionAt(double inclination, double azimuth) { return DirectionJetAt(inclination, azimuth).l; }

Matrix3d RollPitchYaw(const Vector3d& angles) {
  return Turn(2, angles[0]) * Turn(1, angles[1]) * Turn(0, angles[2]);
}

Vector3d AnglesOf(const Matrix3d& R) {
  return {std::atan2(R(1, 0), R(0, 0)), -std::asin(std::clamp(R(2, 0), -1.0, 1.0)),
          std::atan2(R(2, 1), R(2, 2))};
}

std::pair<std::size_t, std::size_t> NearestQuarterTurn(Poses poses) {
  std::vector<Eigen::Quaterniond> turns;
  turns.reserve(poses.size());
  for (const Transform& X_BA : poses) turns.emplace_back(X_BA.R);
  std::pair<std::size_t, std::size_t> best{0, 1};
  double least = 2;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    for (std::size_t j = i + 1; j < turns.size(); ++j) {
      const double half = turns[i].dot(turns[j]);  // its size is the cosine of half the angle between
      const double cosine = std::abs(2 * half * half - 1);
      if (cosine >= least) continue;
      least = cosine;
      best = {i, j};
    }
  }
  return best;
}

AxisPair AxisBetween(const Transform& from, const Transform& to) {
  const Vector3d l_A = RotationLog(from.R.transpose() * to.R).normalized();
  return {l_A, from.R * l_A};
}

AxisPair MethodA(Poses poses) {
  const auto [i, j] = NearestQuarterTurn(poses);
  return AxisBetween(poses[i], poses[j]);
}

Matrix3d CorrectedOrientation(const Matrix3d& R, const AxisPair& axes) {
  return Eigen::Quaterniond::FromTwoVectors(R * axes.l_A, axes.l_B).toRotationMatrix() * R;
}

ThesisFit FitAsInThesis(JointType type, Poses poses, const CgOptions& options) {
  CgMinimum minimum;
  Joint joint;
  switch (type) {
    case JointType::kPrismatic:
      minimum = MinimizePrismatic(poses, options);
      joint = Prismatic(poses, RollPitchYaw(minimum.x));
      break;
    case JointType::kRevolute:
    case JointType::kScrew:
      minimum = MinimizeRevolute(poses, options);
      joint = OnAxis(type, poses,
                     {DirectionAt(minimum.x[0], minimum.x[1]), DirectionAt(minimum.x[2], minimum.x[3])});
      break;
    case JointType::kTwoAxis:
      minimum = MinimizeTwoAxis(poses, options);
      joint.type = type;
      joint.X_AJ.R = RollPitchYaw(minimum.x.head<3>());
      joint.X_BJ.R = RollPitchYaw(minimum.x.tail<3>());
      break;
    default:
      throw PreconditionError("FitAsInThesis: expected prismatic, revolute, screw or two-axis, got " +
                              std::string(NameOf(type)));
  }
  return {joint, minimum.value, minimum.iterations, minimum.converged};
}

}  // namespace tact::joint
