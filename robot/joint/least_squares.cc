#include "robot/joint/least_squares.h"

#include <numbers>
#include <optional>

#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

struct Axes {
  Vector3d l_A, l_B;
};

// What the first pass gathers; locations count from the first one, which keeps their spread exact far from the origin.
struct Moments {
  double count = 0;
  Transform first;
  Matrix3d orientations = Matrix3d::Zero();
  Vector3d locations = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();

  OrientationMoment second;  // of two-axis joints only

  Moments(const PosePass& pass, JointType type) {
    pass([this, type](const Transform& X_BA) {
      if (count == 0) first = X_BA;
      count += 1;
      orientations += X_BA.R;
      if (type == JointType::kTwoAxis) second.Add(X_BA.R);
      const Vector3d p = X_BA.p - first.p;
      locations += p;
      squares.noalias() += p * p.transpose();
    });
  }
  Vector3d Mean() const { return first.p + locations / count; }
  SymmetricEigen3 Components() const { return EigenOf(squares - locations * locations.transpose() / count); }
};

// The directions that the orientations map to one another best: the least sum of |l_B - R_i l_A|^2.
Axes AxesByOrientation(const Moments& moments) {
  const Svd3 svd = SvdOf(moments.orientations);
  return {svd.V.col(0), svd.U.col(0)};
}

Axes AxesByMotion(const Moments& moments, bool across) {
  const Vector3d l_B = moments.Components().vectors.col(across ? 0 : 2);
  return {(moments.orientations.transpose() * l_B).normalized(), l_B};
}

// The orientation nearest to R that maps l_A to l_B [thesis, 4.3.2].
Matrix3d Corrected(const Matrix3d& R, const Axes& axes) {
  const Vector3d turned = R * axes.l_A;
  const double cosine = turned.dot(axes.l_B);
  if (cosine < -0.99) return Eigen::Quaterniond::FromTwoVectors(turned, axes.l_B).toRotationMatrix() * R;
  const Vector3d cross = turned.cross(axes.l_B);
  Matrix3d turn = cross * cross.transpose() / (1 + cosine);
  turn.diagonal().array() += cosine;
  turn(0, 1) -= cross.z(), turn(1, 0) += cross.z();
  turn(0, 2) += cross.y(), turn(2, 0) -= cross.y();
  turn(1, 2) -= cross.x(), turn(2, 1) += cross.x();
  return turn * R;
}

// Frames J on the axes, so that the first pose has the angle zero.
Joint OnAxes(JointType type, const Moments& moments, const Axes& axes) {
  Joint joint{type, {FrameWithZ(axes.l_B), Vector3d::Zero()}, {}, 0, 0};
  joint.X_AJ.R = Corrected(moments.first.R, axes).transpose() * joint.X_BJ.R;
  return joint;
}

// Points c_A, c_B and a factor f by the least sum of |c_B - R c_A + f e - p|^2. As R is a rotation, only sums of
// R, p, e and their products enter the normal equations.
class CenterSums {
 public:
  void Add(const Matrix3d& R, const Vector3d& p, const Vector3d& e = Vector3d::Zero()) {
    count_ += 1;
    R_ += R, p_ += p, e_ += e;
    R_p_.noalias() += R.transpose() * p;
    R_e_.noalias() += R.transpose() * e;
    e_p_ += e.dot(p), e_e_ += e.squaredNorm();
  }
  // c_A, c_B and, if there is any e, f: the shortest solution. With axes: leaving out errors along them, for
  // orientations that map the one to the other.
  SmallVector Solve(bool factor, const std::optional<Axes>& free = {}) const {
    SmallMatrix normal = SmallMatrix::Zero(6 + factor, 6 + factor);
    SmallVector right = SmallVector::Zero(6 + factor);
    normal.diagonal().head<6>().setConstant(count_);
    normal.block<3, 3>(0, 3) = -R_.transpose();
    normal.block<3, 3>(3, 0) = -R_;
    right.head<3>() = -R_p_;
    right.segment<3>(3) = p_;
    if (factor) {
      normal.col(6).head<3>() = -R_e_, normal.row(6).head<3>() = -R_e_;
      normal.col(6).segment<3>(3) = e_, normal.row(6).segment<3>(3) = e_;
      normal(6, 6) = e_e_, right[6] = e_p_;
    }
    if (free) {
      SmallMatrix across = SmallMatrix::Identity(6 + factor, 6 + factor);
      across.topLeftCorner<3, 3>() -= free->l_A * free->l_A.transpose();
      across.block<3, 3>(3, 3) -= free->l_B * free->l_B.transpose();
      normal = across * normal * across;
      right = across * right;
    }
    return SolveSymmetric(normal, right);
  }

 private:
  double count_ = 0, e_p_ = 0, e_e_ = 0;
  Matrix3d R_ = Matrix3d::Zero();
  Vector3d p_ = Vector3d::Zero(), e_ = p_, R_p_ = p_, R_e_ = p_;
};

Joint WithCenters(Joint joint, const SmallVector& solution) {
  joint.X_AJ.p = solution.head<3>();
  joint.X_BJ.p = solution.segment<3>(3);
  return joint;
}

Joint FitRigid(const Moments& moments) {
  return {JointType::kRigid, {NearestRotation(moments.orientations), moments.Mean()}, {}, 0, 0};
}

Joint FitPrismatic(const Moments& moments) {
  const Matrix3d R_BA = NearestRotation(moments.orientations);
  const Transform X_BJ{FrameWithZ(moments.Components().vectors.col(2)), moments.Mean()};
  return {JointType::kPrismatic, X_BJ, {R_BA.transpose() * X_BJ.R, Vector3d::Zero()}, 0, 0};
}

// Revolute, cylindrical, screw.
Joint FitAboutAxis(JointType type, const Moments& moments, const PosePass& pass, const Axes& axes) {
  Joint joint = OnAxes(type, moments, axes);
  const bool screws = type == JointType::kScrew;
  CenterSums sums;
  double angle = 0;
  pass([&](const Transform& X_BA) {
    if (screws) angle = ContinuousWith(CoordinatesNear(joint, X_BA)[0], angle);
    sums.Add(Corrected(X_BA.R, axes), X_BA.p - moments.first.p, angle * axes.l_B);
  });
  const bool slides = type == JointType::kCylindrical;
  const SmallVector solution = sums.Solve(screws, slides ? std::optional(axes) : std::nullopt);
  joint = WithCenters(joint, solution);
  joint.X_BJ.p += moments.first.p;
  if (screws) joint.pitch = solution[6];
  return joint;
}

Joint FitSpherical(const Moments& moments, const PosePass& pass) {
  CenterSums sums;
  pass([&](const Transform& X_BA) { sums.Add(X_BA.R, X_BA.p - moments.first.p); });
  Joint joint{JointType::kSpherical, {}, {moments.first.R.transpose(), Vector3d::Zero()}, 0, 0};
  joint = WithCenters(joint, sums.Solve(false));
  joint.X_BJ.p += moments.first.p;
  return joint;
}

Joint FitPlanar(const Moments& moments, const Axes& axes) {
  Joint joint = OnAxes(JointType::kPlanar, moments, axes);
  joint.X_BJ.p = moments.Mean();
  return joint;
}

Joint FitWithAxes(JointType type, const Moments& moments, const PosePass& pass, const Axes& axes) {
  return type == JointType::kPlanar ? FitPlanar(moments, axes) : FitAboutAxis(type, moments, pass, axes);
}

}  // namespace

double ContinuousWith(double angle, double previous) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return angle - kTurn * std::round((angle - previous) / kTurn);
}

void Unwrap(std::span<double> angles) {
  for (std::size_t i = 1; i < angles.size(); ++i) angles[i] = ContinuousWith(angles[i], angles[i - 1]);
}

Joint FitCenters(const TwoAxes& axes, const PosePass& pass) {
  Joint joint{JointType::kTwoAxis, {FrameWithZ(axes.u_B), Vector3d::Zero()}, {}, 0, 0};
  const Matrix3d frame = FrameWithZ(axes.v_A);  // x y z; J_A has its y along v_A
  joint.X_AJ.R << frame.col(1), frame.col(2), frame.col(0);
  CenterSums sums;
  pass([&](const Transform& X_BA) {
    const double first = CoordinatesNear(joint, X_BA)[0];
    sums.Add(X_BA.R, X_BA.p, joint.X_BJ.R * Vector3d(std::cos(first), std::sin(first), 0));
  });
  const SmallVector solution = sums.Solve(true);
  joint = WithCenters(joint, solution);
  joint.offset = solution[6];
  return joint;
}

PosePass PassOver(std::span<const Transform> poses) {
  return [poses](const std::function<void(const Transform&)>& take) {
    for (const Transform& X_BA : poses) take(X_BA);
  };
}

Joint FitLeastSquares(JointType type, const PosePass& pass) {
  const Moments moments(pass, type);
  switch (type) {
    case JointType::kRigid:
      return FitRigid(moments);
    case JointType::kPrismatic:
      return FitPrismatic(moments);
    case JointType::kSpherical:
      return FitSpherical(moments, pass);
    case JointType::kTwoAxis:
      return FitCenters(FindTwoAxes(moments.second), pass);
    default:
      return FitWithAxes(type, moments, pass, AxesByOrientation(moments));
  }
}

Joint FitLeastSquares(JointType type, std::span<const Transform> poses) {
  return FitLeastSquares(type, PassOver(poses));
}

std::vector<Joint> StartsOf(JointType type, std::span<const Transform> poses) {
  std::vector<Joint> starts = {FitLeastSquares(type, poses)};
  if (type == JointType::kPlanar || type == JointType::kCylindrical || type == JointType::kScrew) {
    const PosePass pass = PassOver(poses);
    const Moments moments(pass, type);
    starts.push_back(FitWithAxes(type, moments, pass, AxesByMotion(moments, type == JointType::kPlanar)));
  }
  return starts;
}

}  // namespace tact::joint
