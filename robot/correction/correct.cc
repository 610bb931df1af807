#include "robot/correction/correct.h"

#include "robot/correction/gauss_newton.h"
#include "robot/correction/linear_correction.h"

namespace tact::correction {

std::string ToString(Method method) {
  switch (method) {
    case Method::kGaussNewton:
      return "non-linear";
    case Method::kLinear:
      return "linear";
    case Method::kNearest:
      return "nearest";
    case Method::kNearestRotationFirst:
      return "nearest, rotation first";
  }
  return "";
}

Correction Correct(Method method, const Models& models, const Relation& relation,
                   const joint::Transform& X_FM) {
  Correction correction;
  const auto take = [&](const auto& answer) {
    correction.X_FM = answer.X_FM;
    correction.outcome = answer.outcome;
  };
  switch (method) {
    case Method::kGaussNewton:
      take(CorrectByGaussNewton(models, relation.contacts, X_FM));
      break;
    case Method::kLinear:
      take(CorrectLinearly(models, relation, X_FM));
      break;
    case Method::kNearest:
    case Method::kNearestRotationFirst: {
      Metric metric;
      metric.rotation_first = method == Method::kNearestRotationFirst;
      take(NearestPose(models, relation, metric).Find(X_FM));
      break;
    }
  }
  const Displacement displacement = DisplacementBetween(X_FM, correction.X_FM, Eigen::Vector3d::Zero());
  correction.rotation = displacement.rotation;
  correction.translation = displacement.translation;
  return correction;
}

}  // namespace tact::correction
