/// @file
/// Answers of `tact joint` as text for people and as JSON.
/// JSON    {"type","reason","parameters":{NAME:{"value","unit","frame","error","error_unit","determined"}},
///         "covariance":{NAME:3 x 3},"noise":{"rotation","translation"},"scores":{TYPE:BIC},"candidates":[TYPE],"poses":N,
///         "outliers":[pose, from 0],"coordinates":[{"name","unit","least","most"}],"values":[[a pose's coordinates]],
///         "held_back":{...} with --predict,"notes":[...]}
/// Units   JSON: metre, radian; text: the length unit asked for, degrees.
#pragma once

#include <string>

#include "cli/joint_answer.h"
#include "robot/cad/length_unit.h"

namespace tact::cli {

std::string JointToJson(const JointAnswer& answer);
std::string JointToText(const JointAnswer& answer, cad::LengthUnit unit);

/// In which errors stand: millimetres where the unit is metric.
cad::LengthUnit SmallUnit(cad::LengthUnit unit);

/// Pieces that the page shows, too.
struct JointRow {
  std::string name, frame, value, error;
};
std::vector<JointRow> ParameterRows(const JointAnswer& answer, cad::LengthUnit unit);
/// "angle from 0.0 to 89.3 deg".
std::vector<std::string> CoordinateRanges(const JointAnswer& answer, cad::LengthUnit unit);
/// "0.52 deg and 2.1 mm a component".
std::string NoiseText(const JointAnswer& answer, cad::LengthUnit unit);
/// "half of the poses within ...".
std::string HeldBackText(const JointAnswer& answer, cad::LengthUnit unit);
/// Type, parameters, BIC, above the best; the best first.
std::vector<std::vector<std::string>> ScoreRows(const JointAnswer& answer);
/// "revolute joint from 120 poses".
std::string JointTitle(const JointAnswer& answer);
/// "lines 3, 7 and 9".
std::string OutlierLines(const JointAnswer& answer);

}  // namespace tact::cli
