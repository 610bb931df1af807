#include "algebra/error.h"
#include "cli/joint_answer.h"
#include "cli/joint_page.h"
#include "cli/joint_text.h"
#include "cli/output.h"
#include "robot/input/json_stream.h"

namespace tact::cli {
namespace {

input::PoseLog ReadLog(const std::string& path, const input::PoseLogOptions& options) {
  input::InputFile file(path);
  return input::ReadPoseLog(file.stream(), file.name(), options);
}

std::optional<cad::LengthUnit> UnitOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto unit = cad::ParseLengthUnit(text);
  if (!unit) throw InputError("--unit: expected mm, cm, m or in, the unit of locations, got " + text);
  return unit;
}

}  // namespace

ExitStatus RunJoint(const JointOptions& options) {
  if (options.method != "robust" && options.type.empty())
    throw InputError("--method " + options.method +
                     ": expected a --type, got none; types are compared robustly");
  const auto unit = UnitOf(options.unit);
  std::vector<input::PoseLog> logs;
  for (const std::string& path : options.files)
    logs.push_back(ReadLog(path, {.unit = unit, .scalar_first = options.quaternion == "wxyz"}));
  if (logs.size() > 1 && options.inverse)
    throw InputError("--inverse: expected one log, got two; exchange the files instead");
  JointAnswer answer = AnswerJoint(logs.size() == 1 ? joint::SeriesOf(logs[0], options.inverse)
                                                    : joint::SeriesOf(logs[0], logs[1], options.time_limit),
                                   options);
  for (const input::PoseLog& log : logs) {
    answer.read.push_back(log.name + ": " + std::to_string(log.poses.size()) + " poses, " + log.description);
    answer.notes.insert(answer.notes.begin(), log.notes.begin(), log.notes.end());
  }
  const cad::LengthUnit shown = unit.value_or(cad::LengthUnit::kMetre);
  if (!options.page.empty()) WriteJointPage(answer, shown, options.page);
  for (const std::string& note : answer.notes) Note(note);
  Output output;
  output << (options.json ? JointToJson(answer) : JointToText(answer, shown));
  output.Flush();
  return answer.complete ? kAnswered : kUndecided;
}

}  // namespace tact::cli
