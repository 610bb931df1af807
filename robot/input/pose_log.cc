#include "robot/input/pose_log.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "algebra/error.h"
#include "robot/cad/text_lines.h"
#include "robot/input/json_value.h"
#include "robot/input/pose.h"
#include "robot/input/rotation_quaternion.h"
#include "robot/input/text_token.h"

namespace tact::input {
namespace {

constexpr std::string_view kForms =
    "a pose: x y z qx qy qz qw, before it a time (TUM), twelve numbers of a matrix (KITTI), a header that "
    "names the "
    "columns, or JSON";

std::string_view Trimmed(std::string_view text) {
  const size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

bool IsNumberStart(char c) { return std::string_view("+-.0123456789").find(c) != std::string_view::npos; }

bool IsComment(std::string_view line) { return line.front() == '#' || line.front() == '%'; }

std::string Short(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// The columns of a line without a header.
std::array<int, kLogFields> PlainColumns(bool time, bool scalar_first) {
  std::array<int, kLogFields> columns{};
  for (int i = 0; i < kLogFields; ++i) columns[i] = time ? i : i - 1;
  if (scalar_first) {
    const int w = columns[kLogQx];
    for (const int i : {kLogQx, kLogQy, kLogQz}) ++columns[i];
    columns[kLogQw] = w;
  }
  return columns;
}

}  // namespace

PoseLogStream::PoseLogStream(std::istream& in, std::string source, PoseLogOptions options)
    : in_(in), source_(std::move(source)), options_(options) {
  unit_ = options_.unit.value_or(cad::LengthUnit::kMetre);
}

void PoseLogStream::FailAtLine(const std::string& message) const {
  SourceText{line_, source_, number_}.Fail(std::min(line_.find_first_not_of(" \t"), line_.size()), message);
}

bool PoseLogStream::ReadLine() {
  while (std::getline(in_, line_)) {
    ++number_;
    const std::string_view text = Trimmed(line_);
    if (text.empty()) continue;
    if (!IsComment(text)) return true;
    if (form_ != PoseLogForm::kUnknown) continue;
    LogHeader header = ParseLogHeader(text);
    if (header.Missing().empty()) UseHeader(std::move(header));
  }
  if (in_.bad())
    throw InputError(source_ + ": expected a readable file, got an error of the system while reading");
  return false;
}

void PoseLogStream::UseHeader(LogHeader header) {
  if (!header.twice.empty()) FailAtLine("expected each column once, got two of " + Quote(header.twice));
  if (header.unit && options_.unit && *header.unit != *options_.unit) {
    FailAtLine("expected locations in " + std::string(ToString(*options_.unit)) +
               ", as --unit says, got a header in " + std::string(ToString(*header.unit)));
  }
  unit_ = header.unit.value_or(unit_);
  header_ = std::move(header);
  form_ = PoseLogForm::kTable;
}

void PoseLogStream::SplitLine() {
  fields_.clear();
  const std::string_view line = line_;
  const std::string_view separator =
      header_.separator == ' ' ? std::string_view(" \t\r") : std::string_view(&header_.separator, 1);
  for (size_t start = 0; start <= line.size();) {
    const size_t end = std::min(line.find_first_of(separator, start), line.size());
    const std::string_view field = Trimmed(line.substr(start, end - start));
    // An empty field keeps its place in the line.
    if (!field.empty() || header_.separator != ' ')
      fields_.push_back(field.empty() ? line.substr(start, 0) : field);
    start = end + 1;
  }
}

// Sets form_ by the current line; a header is consumed.
void PoseLogStream::Recognise() {
  if (Trimmed(line_).front() == '{') {
    form_ = PoseLogForm::kJson;
    return;
  }
  SplitLine();
  const bool numbers = IsNumberStart(fields_.front().front());
  const bool table = line_.find_first_of(",;") != std::string::npos && fields_.size() < 7;
  if (numbers && !table) {
    switch (fields_.size()) {
      case 7:
        form_ = PoseLogForm::kPlain;
        break;
      case 8:
        form_ = PoseLogForm::kTum;
        break;
      case 12:
        form_ = PoseLogForm::kKitti;
        break;
      default:
        FailAtLine("expected " + std::string(kForms) + ", got " + std::to_string(fields_.size()) + " fields");
    }
    header_.columns = PlainColumns(form_ == PoseLogForm::kTum, options_.scalar_first);
    header_.count = static_cast<int>(fields_.size());
    return;
  }
  LogHeader header = ParseLogHeader(line_);
  if (!header.knows_any()) {
    if (numbers)
      FailAtLine(
          "expected a header that names the columns before the numbers, such as time,x,y,z,qx,qy,qz,qw, got "
          "none");
    FailAtLine("expected " + std::string(kForms) + ", got " + Quote(line_));
  }
  if (const auto missing = header.Missing(); !missing.empty())
    FailAtLine("expected columns x, y, z, qx, qy, qz and qw, got a header without " + QuoteList(missing));
  UseHeader(std::move(header));
}

double PoseLogStream::Number(size_t field) const {
  const std::string_view word = fields_[field];
  const auto value = cad::ParseFinite(word);
  if (!value) {
    SourceText{line_, source_, number_}.Fail(
        static_cast<size_t>(word.data() - line_.data()),
        "expected a finite number, got " + (word.empty() ? "an empty field" : Quote(word)));
  }
  return *value;
}

std::array<double, 4> PoseLogStream::Quaternion(const std::array<int, kLogFields>& columns) {
  std::array<double, 4> q{Number(columns[kLogQw]), Number(columns[kLogQx]), Number(columns[kLogQy]),
                          Number(columns[kLogQz])};
  const double length = NormaliseQuaternion(&q);
  if (length == 0) {
    const int first = *std::min_element(columns.begin() + kLogQx, columns.end());
    SourceText{line_, source_, number_}.Fail(static_cast<size_t>(fields_[first].data() - line_.data()),
                                             "expected a quaternion that is not zero, got 0 0 0 0");
  }
  shortest_ = std::min(shortest_, length);
  longest_ = std::max(longest_, length);
  return q;
}

std::array<double, 4> PoseLogStream::Matrix() const {
  RotationRows rows;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) rows[i][j] = Number(4 * i + j);
  }
  if (const auto fault = RotationFault(rows, kLargestLogMatrixError))
    FailAtLine("expected a rotation matrix in columns 1-3, 5-7 and 9-11, got no rotation: " + *fault);
  std::array<double, 4> q = QuaternionOf(rows);
  NormaliseQuaternion(&q);
  return q;
}

LoggedPose PoseLogStream::ParseJson() {
  const JsonDocument document = JsonDocument::Parse(line_, source_, number_);
  const TimedPoseInput timed = ParseTimedPose(document.root());
  if (!started_) has_times_ = timed.time.has_value();
  if (has_times_ != timed.time.has_value()) {
    document.root().Fail(has_times_ ? "expected a \"time\", as the poses before have one, got none"
                                    : "expected no \"time\", as the poses before have none, got one");
  }
  LoggedPose pose;
  if (timed.time) pose.time = ToDouble(*timed.time);
  RotationRows rows;
  for (int i = 0; i < 3; ++i) {
    pose.location[i] = ToDouble(timed.pose.translation[i]);
    for (int j = 0; j < 3; ++j) rows[i][j] = ToDouble(timed.pose.rotation.rows[i][j]);
  }
  pose.rotation = QuaternionOf(rows);
  NormaliseQuaternion(&pose.rotation);
  return pose;
}

// nullopt: the line was a header.
std::optional<LoggedPose> PoseLogStream::ParseLine() {
  if (form_ == PoseLogForm::kUnknown) {
    Recognise();
    if (form_ == PoseLogForm::kTable) return std::nullopt;
  }
  if (form_ == PoseLogForm::kJson) return ParseJson();
  SplitLine();
  if (static_cast<int>(fields_.size()) != header_.count) {
    // A word in the middle says more than a wrong count.
    for (size_t field = 0; field < fields_.size() && form_ != PoseLogForm::kTable; ++field) Number(field);
    FailAtLine("expected " + std::to_string(header_.count) + " fields, as in the lines before, got " +
               std::to_string(fields_.size()));
  }
  LoggedPose pose;
  if (form_ == PoseLogForm::kKitti) {
    pose.rotation = Matrix();
    for (int i = 0; i < 3; ++i) pose.location[i] = Number(4 * i + 3);
    return pose;
  }
  has_times_ = header_.columns[kLogTime] >= 0;
  if (has_times_) pose.time = header_.seconds * Number(header_.columns[kLogTime]);
  for (int i = 0; i < 3; ++i) pose.location[i] = Number(header_.columns[kLogX + i]);
  pose.rotation = Quaternion(header_.columns);
  return pose;
}

std::optional<LoggedPose> PoseLogStream::Next() {
  while (ReadLine()) {
    std::optional<LoggedPose> pose = ParseLine();
    if (!pose) continue;
    pose->line = number_;
    const double metres = ToDouble(Ratio(unit_, cad::LengthUnit::kMetre));
    for (double& value : pose->location) {
      value *= metres;
      if (std::abs(value) > kFarthestLocation)
        FailAtLine("expected a location within " + Short(kFarthestLocation) + " m, got " + Short(value) +
                   " m");
    }
    if (has_times_ && started_ && pose->time < last_time_) {
      FailAtLine("expected times in order, got " + Short(pose->time) + " s after " + Short(last_time_) +
                 " s; sort the lines by time");
    }
    last_time_ = pose->time;
    started_ = true;
    return pose;
  }
  return std::nullopt;
}

std::string PoseLogStream::Description() const {
  const std::string order = options_.scalar_first ? "qw qx qy qz" : "qx qy qz qw";
  const std::string in = ", locations in " + std::string(ToString(unit_));
  switch (form_) {
    case PoseLogForm::kUnknown:
      return "nothing";
    case PoseLogForm::kJson:
      return "JSON lines" + in;
    case PoseLogForm::kTable:
      return "a table with a header" + in;
    case PoseLogForm::kTum:
      return "TUM lines (time x y z " + order + ")" + in;
    case PoseLogForm::kPlain:
      return "lines x y z " + order + in;
    case PoseLogForm::kKitti:
      return "KITTI lines (rows of a 3 x 4 matrix)" + in;
  }
  return "";
}

std::vector<std::string> PoseLogStream::Notes() const {
  if (longest_ - 1 <= kUnusualQuaternion && 1 - shortest_ <= kUnusualQuaternion) return {};
  return {source_ + ": quaternions of lengths from " + Short(shortest_) + " to " + Short(longest_) +
          " are taken as the rotations they name: are the columns as expected?"};
}

PoseLog ReadPoseLog(std::istream& in, const std::string& source, const PoseLogOptions& options) {
  PoseLogStream stream(in, source, options);
  PoseLog log;
  log.name = source;
  while (auto pose = stream.Next()) log.poses.push_back(*pose);
  if (log.poses.empty()) throw InputError(source + ":1:1: expected " + std::string(kForms) + ", got no pose");
  log.has_times = stream.has_times();
  log.description = stream.Description();
  log.notes = stream.Notes();
  return log;
}

}  // namespace tact::input
