#include "robot/joint/maximum_likelihood.h"

#include <cmath>

#include "robot/joint/least_squares.h"
#include "robot/joint/small_matrix.h"

namespace tact::joint {
namespace {

using Poses = std::span<const Transform>;

constexpr double kSmallestScale = 1e-12;  // radian, metre: noise-free data stay solvable in doubles
constexpr double kFirstRotation =
    0.01;  // radian: where the start leaves no error of orientation (spherical), a usual one

// An orthonormal basis of the columns of J, and the triangle T with J = Q T. Columns that add nothing are left out of Q.
struct Basis {
  CoordinateJacobian Q;
  Eigen::Matrix3d T = Eigen::Matrix3d::Zero();
  std::array<bool, kMostDof> kept{};
};
Basis BasisOf(const CoordinateJacobian& J) {
  Basis basis{CoordinateJacobian::Zero(6, J.cols()), {}, {}};
  basis.T.setZero();
  for (Eigen::Index i = 0; i < J.cols(); ++i) {
    Vector6 column = J.col(i);
    for (Eigen::Index j = 0; j < i; ++j) {
      basis.T(j, i) = basis.Q.col(j).dot(column);
      column -= basis.T(j, i) * basis.Q.col(j);
    }
    const double norm = column.norm();
    basis.kept[static_cast<std::size_t>(i)] = norm > 1e-12 * J.col(i).norm();
    if (!basis.kept[static_cast<std::size_t>(i)]) continue;
    basis.T(i, i) = norm;
    basis.Q.col(i) = column / norm;
  }
  return basis;
}

// x with T x = Q^T right.
Eigen::Vector3d SolveBasis(const Basis& basis, const Vector6& right) {
  Eigen::Vector3d x = Eigen::Vector3d::Zero();
  for (Eigen::Index i = basis.Q.cols() - 1; i >= 0; --i) {
    if (!basis.kept[static_cast<std::size_t>(i)]) continue;
    double rest = basis.Q.col(i).dot(right);
    for (Eigen::Index j = i + 1; j < basis.Q.cols(); ++j) rest -= basis.T(i, j) * x[j];
    x[i] = rest / basis.T(i, i);
  }
  return x;
}

// One pose's equations, weighted by the scales.
struct PoseEquations {
  ParameterJacobian parameters;
  Basis basis;
  Vector6 error;
};
PoseEquations EquationsOf(const Joint& joint, const Coordinates& q, const Transform& X_BA,
                          const NoiseScale& noise) {
  JointJacobian jacobian = JacobianAt(joint, q);
  Vector6 error = PoseError(joint, q, X_BA);
  jacobian.parameters.topRows<3>() /= noise.rotation;
  jacobian.parameters.bottomRows<3>() /= noise.translation;
  jacobian.coordinates.topRows<3>() /= noise.rotation;
  jacobian.coordinates.bottomRows<3>() /= noise.translation;
  error.head<3>() /= noise.rotation;
  error.tail<3>() /= noise.translation;
  return {jacobian.parameters, BasisOf(jacobian.coordinates), error};
}

// Sums over the poses, the coordinates eliminated; index 0 rotation, 1 translation.
struct Normal {
  ParameterMatrix information;
  std::array<ParameterMatrix, 2> information_of;
  ParameterVector gradient;
  std::array<double, 2> squares{}, redundancy{};

  explicit Normal(int parameters)
      : information(ParameterMatrix::Zero(parameters, parameters)),
        gradient(ParameterVector::Zero(parameters)) {
    information_of.fill(information);
  }
  void Add(const PoseEquations& pose, double weight) {
    const ParameterJacobian J =
        pose.parameters - pose.basis.Q * (pose.basis.Q.transpose() * pose.parameters).eval();
    const Vector6 e = pose.error - pose.basis.Q * (pose.basis.Q.transpose() * pose.error).eval();
    for (int group = 0; group < 2; ++group) {
      const auto at = static_cast<std::size_t>(group);
      const auto rows = J.middleRows<3>(3 * group);
      information_of[at].noalias() += weight * (rows.transpose() * rows);
      squares[at] += weight * e.segment<3>(3 * group).squaredNorm();
      redundancy[at] += 3 - pose.basis.Q.middleRows<3>(3 * group).squaredNorm();
    }
    gradient.noalias() += weight * (J.transpose() * e);
  }
  void Finish() { information = information_of[0] + information_of[1]; }
};

double ContinuousWith(double angle, double previous) {
  constexpr double kTurn = 2 * M_PI;
  return angle - kTurn * std::round((angle - previous) / kTurn);
}

// Which coordinates are angles that go on past pi.
int TurningCoordinates(JointType type) {
  switch (type) {
    case JointType::kRevolute:
    case JointType::kScrew:
    case JointType::kCylindrical:
    case JointType::kPlanar:
      return 1;
    case JointType::kTwoAxis:
      return 2;
    default:
      return 0;
  }
}

std::vector<Coordinates> CoordinatesAlong(const Joint& joint, Poses poses) {
  std::vector<Coordinates> along;
  along.reserve(poses.size());
  for (const Transform& X_BA : poses) {
    Coordinates q = CoordinatesNear(joint, X_BA);
    if (!along.empty()) {
      for (int i = 0; i < TurningCoordinates(joint.type); ++i) q[i] = ContinuousWith(q[i], along.back()[i]);
    }
    along.push_back(q);
  }
  return along;
}

double Squares(const Joint& joint, const std::vector<Coordinates>& q, Poses poses, const NoiseScale& noise,
               std::span<const double> weights) {
  double sum = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector6 e = PoseError(joint, q[i], poses[i]);
    const double squares = e.head<3>().squaredNorm() / (noise.rotation * noise.rotation) +
                           e.tail<3>().squaredNorm() / (noise.translation * noise.translation);
    sum += (weights.empty() ? 1 : weights[i]) * squares;
  }
  return sum;
}

NoiseScale FirstScale(const Joint& joint, const std::vector<Coordinates>& q, Poses poses) {
  double rotation = 0, translation = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const Vector6 e = PoseError(joint, q[i], poses[i]);
    rotation += e.head<3>().squaredNorm();
    translation += e.tail<3>().squaredNorm();
  }
  const double count = 3 * static_cast<double>(poses.size());
  const bool turns_freely = joint.type == JointType::kSpherical;
  return {turns_freely ? kFirstRotation : std::max(kSmallestScale, std::sqrt(rotation / count)),
          std::max(kSmallestScale, std::sqrt(translation / count))};
}

}  // namespace

JointFit ClimbLikelihood(const Joint& start, Poses poses, const FitOptions& options) {
  const int parameters = JointParameters(start.type);
  JointFit fit{start, CoordinatesAlong(start, poses), {}, {}, 0, 0, 0, false};
  fit.noise = options.noise ? *options.noise : FirstScale(start, fit.coordinates, poses);
  double damping = 0;
  std::vector<Coordinates> tried(poses.size());
  for (; fit.iterations < options.most_iterations && !fit.converged; ++fit.iterations) {
    Normal normal(parameters);
    for (std::size_t i = 0; i < poses.size(); ++i) {
      normal.Add(EquationsOf(fit.joint, fit.coordinates[i], poses[i], fit.noise),
                 options.weights.empty() ? 1 : options.weights[i]);
    }
    normal.Finish();
    fit.covariance = PseudoInverse(normal.information, 1e-12, &fit.rank);
    const double now = Squares(fit.joint, fit.coordinates, poses, fit.noise, options.weights);
    // A step that lowers the sum, damped as long as it does not (Levenberg and Marquardt).
    ParameterVector step;
    Joint joint;
    double next = now;
    for (int attempt = 0; attempt < 12; ++attempt) {
      ParameterMatrix damped = normal.information;
      damped.diagonal() *= 1 + damping;
      step = PseudoInverse(damped, 1e-12) * normal.gradient;
      joint = Changed(fit.joint, step);
      for (std::size_t i = 0; i < poses.size(); ++i) {
        const PoseEquations pose = EquationsOf(fit.joint, fit.coordinates[i], poses[i], fit.noise);
        tried[i] = Changed(fit.joint, fit.coordinates[i],
                           SolveBasis(pose.basis, pose.error - pose.parameters * step));
      }
      next = Squares(joint, tried, poses, fit.noise, options.weights);
      if (next <= now * (1 + 1e-12)) break;
      damping = std::max(1e-4, 10 * damping);
    }
    const bool better = next <= now * (1 + 1e-12);
    if (better) {
      fit.joint = joint;
      fit.coordinates.swap(tried);
      damping = damping < 1e-6 ? 0 : damping / 10;
    }
    fit.squares = std::min(now, next);
    bool settled = !better || now - next <= 1e-10 * now;
    if (!options.noise) {
      std::array<double, 2> factor{};
      for (std::size_t group = 0; group < 2; ++group) {
        const double redundancy =
            normal.redundancy[group] - (fit.covariance * normal.information_of[group]).trace();
        factor[group] = redundancy > 1e-6 ? std::sqrt(normal.squares[group] / redundancy) : 1;
        if (std::abs(factor[group] - 1) > 1e-4) settled = false;
      }
      fit.noise.rotation = std::max(kSmallestScale, fit.noise.rotation * factor[0]);
      fit.noise.translation = std::max(kSmallestScale, fit.noise.translation * factor[1]);
    }
    fit.converged = settled;
  }
  return fit;
}

JointFit FitMaximumLikelihood(JointType type, Poses poses, const FitOptions& options) {
  std::optional<JointFit> best;
  for (const Joint& start : StartsOf(type, poses)) {
    JointFit fit = ClimbLikelihood(start, poses, options);
    const auto spread = [](const JointFit& f) {
      return std::log(f.noise.rotation) + std::log(f.noise.translation);
    };
    const bool better = !best || (options.noise ? fit.squares < best->squares : spread(fit) < spread(*best));
    if (better) best = std::move(fit);
  }
  return *best;
}

}  // namespace tact::joint
