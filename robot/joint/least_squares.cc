#include "robot/joint/least_squares.h"

#include <numbers>

#include "robot/joint/small_matrix.h"
#include "robot/joint/two_axis_search.h"

namespace tact::joint {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Poses = std::span<const Transform>;

struct Axes {
  Vector3d l_A, l_B;
};

struct Spread {
  Vector3d mean;
  SymmetricEigen3 components;
};

Matrix3d SumOfOrientations(Poses poses) {
  Matrix3d sum = Matrix3d::Zero();
  for (const Transform& X_BA : poses) sum += X_BA.R;
  return sum;
}

Spread SpreadOf(Poses poses) {
  Vector3d mean = Vector3d::Zero();
  for (const Transform& X_BA : poses) mean += X_BA.p;
  mean /= static_cast<double>(poses.size());
  Matrix3d covariance = Matrix3d::Zero();
  for (const Transform& X_BA : poses) covariance.noalias() += (X_BA.p - mean) * (X_BA.p - mean).transpose();
  return {mean, EigenOf(covariance)};
}

// The directions that the orientations map to one another best: the least sum of |l_B - R_i l_A|^2.
Axes AxesByOrientation(Poses poses) {
  const Svd3 svd = SvdOf(SumOfOrientations(poses));
  return {svd.V.col(0), svd.U.col(0)};
}

Axes AxesByMotion(Poses poses, bool across) {
  const Vector3d l_B = SpreadOf(poses).components.vectors.col(across ? 0 : 2);
  return {(SumOfOrientations(poses).transpose() * l_B).normalized(), l_B};
}

// The orientation nearest to R that maps l_A to l_B [thesis, 4.3.2].
Matrix3d Corrected(const Matrix3d& R, const Axes& axes) {
  return Eigen::Quaterniond::FromTwoVectors(R * axes.l_A, axes.l_B).toRotationMatrix() * R;
}

// Frames J on the axes, so that the first pose has the angle zero.
Joint OnAxes(JointType type, Poses poses, const Axes& axes) {
  Joint joint{type, {FrameWithZ(axes.l_B), Vector3d::Zero()}, {}, 0, 0};
  joint.X_AJ.R = Corrected(poses.front().R, axes).transpose() * joint.X_BJ.R;
  return joint;
}

// Points c_A, c_B (and more unknowns) by the least sum of |P (c_B - R c_A + extra e - p)|^2, P leaving out the direction
// `free` of B if it is not zero.
class CenterEquations {
 public:
  CenterEquations(int extras, const Vector3d& free)
      : extras_(extras), P_(Matrix3d::Identity() - free * free.transpose()) {
    normal_ = SmallMatrix::Zero(6 + extras, 6 + extras);
    right_ = SmallVector::Zero(6 + extras);
  }
  void Add(const Matrix3d& R, const Vector3d& p, const Vector3d& extra = Vector3d::Zero()) {
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 7> A(3, 6 + extras_);
    A.leftCols<3>() = -R;
    A.middleCols<3>(3).setIdentity();
    if (extras_) A.col(6) = extra;
    normal_.noalias() += A.transpose() * (P_ * A).eval();
    right_.noalias() += A.transpose() * (P_ * p).eval();
  }
  // c_A, c_B and the extra unknown: the shortest solution.
  SmallVector Solve() const { return SolveSymmetric(normal_, right_); }

 private:
  int extras_;
  Matrix3d P_;
  SmallMatrix normal_;
  SmallVector right_;
};

Joint WithCenters(Joint joint, const SmallVector& solution) {
  joint.X_AJ.p = solution.head<3>();
  joint.X_BJ.p = solution.segment<3>(3);
  return joint;
}

Joint FitRigid(Poses poses) {
  return {JointType::kRigid, {NearestRotation(SumOfOrientations(poses)), SpreadOf(poses).mean}, {}, 0, 0};
}

Joint FitPrismatic(Poses poses) {
  const Matrix3d R_BA = NearestRotation(SumOfOrientations(poses));
  const Spread spread = SpreadOf(poses);
  const Transform X_BJ{FrameWithZ(spread.components.vectors.col(2)), spread.mean};
  return {JointType::kPrismatic, X_BJ, {R_BA.transpose() * X_BJ.R, Vector3d::Zero()}, 0, 0};
}

// Revolute, cylindrical, screw.
Joint FitAboutAxis(JointType type, Poses poses, const Axes& axes) {
  Joint joint = OnAxes(type, poses, axes);
  const bool slides = type == JointType::kCylindrical, screws = type == JointType::kScrew;
  std::vector<double> angles;
  if (screws) {
    angles.reserve(poses.size());
    for (const Transform& X_BA : poses) angles.push_back(CoordinatesNear(joint, X_BA)[0]);
    Unwrap(angles);
  }
  CenterEquations equations(screws, slides ? axes.l_B : Vector3d(Vector3d::Zero()));
  for (std::size_t i = 0; i < poses.size(); ++i) {
    equations.Add(Corrected(poses[i].R, axes), poses[i].p,
                  screws ? Vector3d(angles[i] * axes.l_B) : Vector3d(Vector3d::Zero()));
  }
  const SmallVector solution = equations.Solve();
  joint = WithCenters(joint, solution);
  if (screws) joint.pitch = solution[6];
  return joint;
}

Joint FitSpherical(Poses poses) {
  CenterEquations equations(0, Vector3d::Zero());
  for (const Transform& X_BA : poses) equations.Add(X_BA.R, X_BA.p);
  Joint joint{JointType::kSpherical, {}, {poses.front().R.transpose(), Vector3d::Zero()}, 0, 0};
  return WithCenters(joint, equations.Solve());
}

Joint FitPlanar(Poses poses, const Axes& axes) {
  Joint joint = OnAxes(JointType::kPlanar, poses, axes);
  joint.X_BJ.p = SpreadOf(poses).mean;
  return joint;
}

Joint FitTwoAxis(Poses poses) {
  const TwoAxes axes = FindTwoAxes(poses);
  Joint joint{JointType::kTwoAxis, {FrameWithZ(axes.u_B), Vector3d::Zero()}, {}, 0, 0};
  const Matrix3d frame = FrameWithZ(axes.v_A);  // x y z; J_A has its y along v_A
  joint.X_AJ.R.col(0) = frame.col(1);
  joint.X_AJ.R.col(1) = frame.col(2);
  joint.X_AJ.R.col(2) = frame.col(0);
  CenterEquations equations(1, Vector3d::Zero());
  for (const Transform& X_BA : poses) {
    const double first = CoordinatesNear(joint, X_BA)[0];
    equations.Add(X_BA.R, X_BA.p, joint.X_BJ.R * Vector3d(std::cos(first), std::sin(first), 0));
  }
  const SmallVector solution = equations.Solve();
  joint = WithCenters(joint, solution);
  joint.offset = solution[6];
  return joint;
}

Joint FitWithAxes(JointType type, Poses poses, const Axes& axes) {
  return type == JointType::kPlanar ? FitPlanar(poses, axes) : FitAboutAxis(type, poses, axes);
}

}  // namespace

void Unwrap(std::span<double> angles) {
  constexpr double kTurn = 2 * std::numbers::pi;
  for (std::size_t i = 1; i < angles.size(); ++i) {
    angles[i] -= kTurn * std::round((angles[i] - angles[i - 1]) / kTurn);
  }
}

Joint FitLeastSquares(JointType type, Poses poses) {
  switch (type) {
    case JointType::kRigid:
      return FitRigid(poses);
    case JointType::kPrismatic:
      return FitPrismatic(poses);
    case JointType::kSpherical:
      return FitSpherical(poses);
    case JointType::kTwoAxis:
      return FitTwoAxis(poses);
    default:
      return FitWithAxes(type, poses, AxesByOrientation(poses));
  }
}

std::vector<Joint> StartsOf(JointType type, Poses poses) {
  std::vector<Joint> starts = {FitLeastSquares(type, poses)};
  if (type == JointType::kPlanar || type == JointType::kCylindrical || type == JointType::kScrew) {
    starts.push_back(FitWithAxes(type, poses, AxesByMotion(poses, type == JointType::kPlanar)));
  }
  return starts;
}

}  // namespace tact::joint
