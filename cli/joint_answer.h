/// @file
/// What `tact joint` found out, before it is printed.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "robot/joint/held_back.h"
#include "robot/joint/joint_parameters.h"
#include "robot/joint/joint_selection.h"
#include "robot/joint/pose_series.h"

namespace tact::cli {

struct JointAnswer {
  joint::PoseSeries series;
  std::vector<std::string> read;         // what each log was taken for
  std::vector<std::string> notes;        // what a person should know before believing the answer
  std::optional<joint::JointType> type;  // none: the poses cannot tell
  std::string reason;                    // why this type, or why none
  bool complete = false;                 // a type, and no parameter left open
  std::vector<joint::TypeScore> scores;  // if the type was not given
  std::vector<joint::JointType> candidates;
  // If there is a type:
  joint::RobustFit fit;
  std::vector<joint::NamedParameter> parameters;
  std::vector<joint::Residual> residuals;
  std::optional<joint::PoseErrors> held_back;
};

/// Decides about the poses. PreconditionError is a bug; whatever the poses, there is an answer.
JointAnswer AnswerJoint(joint::PoseSeries series, const JointOptions& options);

/// A coordinate for people.
struct CoordinateName {
  std::string_view name;
  bool angle = false;  // radian; else metre
};
std::vector<CoordinateName> CoordinateNames(joint::JointType type);

/// The least and the largest value of a coordinate among the poses that count.
std::pair<double, double> RangeOf(const JointAnswer& answer, size_t coordinate);

/// "direction of the axis", in words.
std::string ParameterName(joint::JointType type, const joint::NamedParameter& parameter);

}  // namespace tact::cli
