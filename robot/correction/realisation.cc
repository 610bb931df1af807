#include "robot/correction/realisation.h"

#include <Eigen/Cholesky>
#include <cmath>

namespace tact::correction {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using joint::Transform;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

constexpr int kIterations = 60;
constexpr double kEnough = 1e-11;  // times the models' size: root of the sum of squares

// Gaps, and what is violated.
std::vector<Feature> Wanted(const Models& models, const std::vector<recognition::PointContact>& contacts,
                            const Transform& X) {
  std::vector<Feature> wanted;
  const Posed<double> posed = PosedAt(X, Vector3d::Zero());
  for (const auto& contact : contacts) {
    wanted.push_back(GapFeature(contact, models));
    for (const Feature& feature : WithinFeatures(contact, models, X))
      if (ValueOf(feature, posed) < 0) wanted.push_back(feature);
  }
  for (const ConvexPiece& a : models.moving.pieces) {
    for (const ConvexPiece& b : models.fixed.pieces) {
      if (BallGap(a, b, X) > 0) continue;
      const Separation widest = Widest(a, b, X);
      if (widest.gap >= 0) continue;
      for (const Feature& feature : SeparationFeatures(a, b, X, widest, -widest.gap))
        wanted.push_back(feature);
    }
  }
  return wanted;
}

double SumOfSquares(const std::vector<Feature>& wanted, const Transform& X) {
  const Posed<double> posed = PosedAt(X, Vector3d::Zero());
  double sum = 0;
  for (const Feature& feature : wanted) sum += std::pow(ValueOf(feature, posed), 2);
  return sum;
}

Transform Descend(const Models& models, const std::vector<recognition::PointContact>& contacts, Transform X) {
  double damping = 1e-3;
  std::vector<Feature> wanted = Wanted(models, contacts, X);
  double sum = SumOfSquares(wanted, X);
  for (int i = 0; i < kIterations && std::sqrt(sum) > kEnough * models.size; ++i) {
    Matrix6 normal = Matrix6::Zero();
    Vector6 right = Vector6::Zero();
    const Posed<Jet<6>> jet = JetAt(X, Vector3d::Zero());
    for (const Feature& feature : wanted) {
      const Jet<6> value = ValueOf(feature, jet);
      Vector6 row = value.gradient;
      row.head<3>() /= models.size;
      normal += row * row.transpose();
      right -= value.value * row;
    }
    Vector6 step = (normal + damping * Matrix6::Identity()).ldlt().solve(right);
    step.head<3>() /= models.size;
    const Transform next = Stepped(X, Vector3d::Zero(), step);
    std::vector<Feature> then = Wanted(models, contacts, next);
    const double less = SumOfSquares(then, next);
    if (less < sum) {
      X = next, sum = less, wanted = std::move(then);
      damping = std::max(damping / 10, 1e-14);
    } else {
      damping *= 10;
    }
  }
  return X;
}

// The 24 turns that carry a cube to itself, the identity first.
std::vector<Matrix3d> CubeTurns() {
  std::vector<Matrix3d> turns = {Matrix3d::Identity()};
  const Matrix3d x = (Matrix3d() << 1, 0, 0, 0, 0, -1, 0, 1, 0).finished();
  const Matrix3d z = (Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished();
  for (size_t i = 0; i < turns.size(); ++i) {
    for (const Matrix3d& generator : {x, z}) {
      const Matrix3d turn = generator * turns[i];
      bool is_new = true;
      for (const Matrix3d& other : turns) is_new &= (turn - other).norm() > 0.5;
      if (is_new) turns.push_back(turn);
    }
  }
  return turns;
}

}  // namespace

std::optional<Transform> FindRealisation(const Models& models,
                                         const std::vector<recognition::PointContact>& contacts,
                                         const Transform& X_FM) {
  for (const Matrix3d& turn : CubeTurns()) {
    const Transform X = Descend(models, contacts, {turn * X_FM.R, X_FM.p});
    if (Judge(models, contacts, X) == Outcome::kCorrected) return X;
  }
  return std::nullopt;
}

}  // namespace tact::correction
