#include "cli/joint_answer.h"

#include <algorithm>
#include <limits>

#include "robot/joint/joint_gauge.h"
#include "robot/joint/least_squares.h"

namespace tact::cli {
namespace {

using joint::JointType;

joint::JointFit FitAll(JointType type, std::span<const joint::Transform> poses, const std::string& method) {
  if (method == "gaussian") return FitMaximumLikelihood(type, poses);
  joint::FitOptions once;
  once.most_iterations = 1;  // evaluates the start, which stays
  return ClimbLikelihood(InNormalForm(FitLeastSquares(type, poses), poses), poses, once);
}

joint::RobustOptions Seeded(const JointOptions& options) {
  joint::RobustOptions robust;
  robust.seed = options.seed;
  return robust;
}

joint::RobustFit Fit(JointType type, std::span<const joint::Transform> poses, const JointOptions& options) {
  if (options.method == "robust") return FitRobustly(type, poses, Seeded(options));
  joint::RobustFit fit;
  fit.fit = FitAll(type, poses, options.method);
  fit.weights.assign(poses.size(), 1);
  return fit;
}

// Fills in what follows from the fit.
void Describe(JointAnswer* answer, const JointOptions& options) {
  const std::span<const joint::Transform> poses = answer->series.poses;
  const joint::JointFit& fit = answer->fit.fit;
  answer->parameters = NamedParametersOf(fit, poses.front());
  answer->residuals = ResidualsOf(fit, poses);
  answer->complete = std::all_of(answer->parameters.begin(), answer->parameters.end(),
                                 [](const joint::NamedParameter& p) { return p.determined; });
  if (options.predict && poses.size() > 2 * joint::kFolds) {
    answer->held_back = PredictHeldBack(poses, [&](std::span<const joint::Transform> known) {
      return Fit(*answer->type, known, options).fit;
    });
  }
}

}  // namespace

JointAnswer AnswerJoint(joint::PoseSeries series, const JointOptions& options) {
  JointAnswer answer;
  answer.series = std::move(series);
  answer.notes = Suspicions(answer.series);
  if (options.type.empty()) {
    joint::SelectionOptions choice;
    choice.robust = Seeded(options);
    joint::JointSelection selection = SelectJoint(answer.series.poses, choice);
    answer.type = selection.type;
    answer.reason = std::move(selection.reason);
    answer.candidates = std::move(selection.candidates);
    answer.scores = std::move(selection.scores);
    if (!answer.type) return answer;
    answer.fit = answer.scores[static_cast<size_t>(*answer.type)].robust;
  } else {
    answer.type = *std::find_if(joint::kJointTypes.begin(), joint::kJointTypes.end(),
                                [&](JointType type) { return NameOf(type) == options.type; });
    answer.reason = "the type was given";
    answer.fit = Fit(*answer.type, answer.series.poses, options);
  }
  Describe(&answer, options);
  return answer;
}

std::vector<CoordinateName> CoordinateNames(JointType type) {
  switch (type) {
    case JointType::kRigid:
      return {};
    case JointType::kPrismatic:
      return {{"displacement"}};
    case JointType::kRevolute:
    case JointType::kScrew:
      return {{"angle", true}};
    case JointType::kCylindrical:
      return {{"angle", true}, {"displacement"}};
    case JointType::kSpherical:
      return {{"rotation x", true}, {"rotation y", true}, {"rotation z", true}};
    case JointType::kPlanar:
      return {{"angle", true}, {"displacement x"}, {"displacement y"}};
    case JointType::kTwoAxis:
      return {{"first angle", true}, {"second angle", true}};
  }
  return {};
}

std::pair<double, double> RangeOf(const JointAnswer& answer, size_t coordinate) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least = kInfinity, most = -kInfinity;
  for (size_t i = 0; i < answer.fit.fit.coordinates.size(); ++i) {
    if (std::binary_search(answer.fit.outliers.begin(), answer.fit.outliers.end(), i)) continue;
    const double value = answer.fit.fit.coordinates[i][static_cast<Eigen::Index>(coordinate)];
    least = std::min(least, value);
    most = std::max(most, value);
  }
  return {least, most};
}

std::string ParameterName(JointType type, const joint::NamedParameter& parameter) {
  using joint::ParameterKind;
  switch (parameter.kind) {
    case ParameterKind::kDirection:
      if (type == JointType::kPlanar) return "normal of the plane";
      if (type == JointType::kTwoAxis)
        return parameter.frame == joint::Link::kB ? "direction of the first axis"
                                                  : "direction of the second axis";
      return "direction of the axis";
    case ParameterKind::kPoint:
      if (type == JointType::kSpherical) return "centre";
      if (type == JointType::kTwoAxis)
        return parameter.frame == joint::Link::kB ? "point on the first axis" : "point on the second axis";
      if (type == JointType::kRigid || type == JointType::kPrismatic || type == JointType::kPlanar)
        return "origin of A";
      return "point on the axis";
    case ParameterKind::kOrientation:
      return "orientation w x y z";
    case ParameterKind::kPitch:
      return "pitch";
    case ParameterKind::kLength:
      return "offset between the axes";
  }
  return std::string(parameter.name);
}

}  // namespace tact::cli
