/// @file
/// Recorded demonstrations: two models and, scene after scene, the pose of one in the other, whatever file says so.
/// Model   A text tells its form by its first word:
///           No          a pose list (pose_list.h), in the camera's frame
///           {"logs"     {"moving":"peg.off","fixed":"hole.off","unit":"mm","logs":{"moving":"peg.txt",
///                       "fixed":"hole.txt","unit":"m"}}: a log each (pose_log.h), in a common frame, matched by time
///                       (robot/joint/pose_series.h); or "logs":{"relative":"peg_in_hole.txt"}, the moving object's
///                       poses in the fixed one's frame. Logs may also say "quaternion":"wxyz" and "time_limit" (second).
///           {"states"   our own demonstration (demonstration.h)
///         Relative names of files lie in the folder of the file that names them.
/// Frames  M moving, F fixed, C camera (any frame that both were seen in).
/// Units   locations in the models' unit; second; radian.
/// Exact   `exact` where the file wrote a rational pose; X_FM is double always.
/// Errors  InputError `file:line:column: ...` as the readers throw it; among it a demonstration of relations, which has no poses.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "robot/input/cad_relation.h"
#include "robot/joint/transform.h"

namespace tact::input {

/// Of files that do not say so themselves.
struct RecordingOptions {
  std::optional<cad::LengthUnit> unit;  // of a pose list's locations; none: mm
};

struct RecordedScene {
  std::string name;            // its number from 1 where the file gives none
  std::optional<double> time;  // second
  joint::Transform X_FM;
  std::optional<algebra::Pose> exact;    // X_FM as the file wrote it
  std::optional<joint::Transform> X_CF;  // where the fixed object was seen, too
  std::string where;                     // "file:line:column"
};

struct RecordedDemonstration {
  CadModels models;  // `models.unit` is the unit of every length here
  std::vector<RecordedScene> scenes;
  std::string description;         // the form, for people
  std::vector<std::string> notes;  // what a person should know about it
};

/// source names the text in messages; its folder is that of relative names.
RecordedDemonstration ReadRecording(std::istream& in, const std::string& source,
                                    const RecordingOptions& options = {});
/// The same from a file, or from standard input for "-".
RecordedDemonstration ReadRecording(const std::string& path, const RecordingOptions& options = {});

/// The recording as our own JSON demonstration: exact poses as they are, others by the shortest decimals of their
/// doubles. Files keep their names as relative to `folder`, where the text will lie. Loses X_CF.
std::string ToDemonstrationJson(const RecordedDemonstration& recording, const std::filesystem::path& folder);

}  // namespace tact::input
