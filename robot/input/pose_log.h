/// @file
/// Logs of poses: one pose a line, in the forms that trackers write.
/// Model   The first line that says something tells the form:
///           {           JSON lines, poses as in pose.h, "time" beside them if there is one
///           names       a table whose header, a comment or not, names its columns (pose_log_header.h)
///           8 numbers   TUM: time x y z qx qy qz qw
///           7 numbers   x y z qx qy qz qw
///           12 numbers  KITTI: the three rows of [R | p]
///         Lines that begin with # or % are comments; fields stand between blanks or, where a header does so, commas or semicolons.
/// Exact   no: what comes out is double, quaternions brought to length one.
/// Units   metre, second (out).
/// Errors  InputError `file:line:column: expected this, got that`: what is no number, or not finite; too few numbers; a zero
///         quaternion; a matrix that is no rotation by more than kLargestLogMatrixError; a time before the one before it.
/// Cost    the memory of one line.
#pragma once

#include <array>
#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/input/pose_log_header.h"

namespace tact::input {

/// How far a product of two rows may be from that of a rotation: entries written with four decimals are off by up to 2e-4.
inline constexpr double kLargestLogMatrixError = 1e-3;
/// Quaternions of other lengths than 1 by more than this are noted: six decimals leave 1e-6, a wrong column much more.
inline constexpr double kUnusualQuaternion = 1e-2;
/// Metre: farther away no tracker sees, and the squares stay in the range of a double.
inline constexpr double kFarthestLocation = 1e9;

enum class PoseLogForm { kUnknown, kJson, kTable, kTum, kPlain, kKitti };

struct PoseLogOptions {
  std::optional<cad::LengthUnit> unit;  // of locations; none: as the header says, else metre
  bool scalar_first = false;            // without names quaternions are qw qx qy qz
};

struct LoggedPose {
  double time = 0;                             // 0 where the log has none
  std::array<double, 3> location{};            // x y z
  std::array<double, 4> rotation{1, 0, 0, 0};  // w x y z, of length one
  size_t line = 0;
};

class PoseLogStream {
 public:
  /// source names the text in messages.
  PoseLogStream(std::istream& in, std::string source, PoseLogOptions options = {});

  /// The next pose; nullopt at the end.
  std::optional<LoggedPose> Next();

  /// Known once a pose was read.
  bool has_times() const { return has_times_; }
  /// "TUM lines (time x y z qx qy qz qw), locations in m", and what else a person should know of the poses read so far.
  std::string Description() const;
  std::vector<std::string> Notes() const;

 private:
  bool ReadLine();
  void Recognise();
  void UseHeader(LogHeader header);
  [[noreturn]] void FailAtLine(const std::string& message) const;
  std::optional<LoggedPose> ParseLine();
  LoggedPose ParseJson();
  void SplitLine();
  double Number(size_t field) const;
  std::array<double, 4> Quaternion(const std::array<int, kLogFields>& columns);
  std::array<double, 4> Matrix() const;

  std::istream& in_;
  std::string source_, line_;
  PoseLogOptions options_;
  size_t number_ = 0;
  std::vector<std::string_view> fields_;
  PoseLogForm form_ = PoseLogForm::kUnknown;
  LogHeader header_;
  cad::LengthUnit unit_ = cad::LengthUnit::kMetre;
  bool has_times_ = false, started_ = false;
  double last_time_ = 0;
  double shortest_ = 1, longest_ = 1;  // lengths of quaternions
};

struct PoseLog {
  std::string name;
  std::vector<LoggedPose> poses;
  bool has_times = false;
  std::string description;
  std::vector<std::string> notes;
};

/// The whole log; InputError also where it has no pose.
PoseLog ReadPoseLog(std::istream& in, const std::string& source, const PoseLogOptions& options = {});

}  // namespace tact::input
