#include "robot/input/recorded_demonstration.h"

#include <charconv>
#include <cstdio>
#include <sstream>

#include "algebra/error.h"
#include "robot/input/demonstration.h"
#include "robot/input/json_stream.h"
#include "robot/input/length_unit.h"
#include "robot/input/pose_list.h"
#include "robot/input/text_token.h"
#include "robot/joint/pose_series.h"

namespace tact::input {
namespace {

using cad::LengthUnit;
using joint::Transform;

constexpr std::string_view kForms =
    "a recording: \"No of Models: 2\" of a pose list, or JSON with \"moving\", \"fixed\" and either \"logs\" "
    "or "
    "\"states\"";

std::string ReadAll(std::istream& in) {
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

RecordedDemonstration FromList(std::istream& in, const std::string& source, const RecordingOptions& options) {
  const PoseList list = ReadPoseList(in, source);
  RecordedDemonstration recording;
  recording.models = {list.moving, list.fixed, options.unit.value_or(LengthUnit::kMillimetre), 0};
  for (const ListedScene& scene : list.scenes) {
    recording.scenes.push_back({std::to_string(recording.scenes.size() + 1), std::nullopt,
                                scene.X_CF.Inverse() * scene.X_CM, std::nullopt, scene.X_CF, scene.where});
  }
  recording.description = "a pose list, locations in " + std::string(ToString(recording.models.unit));
  return recording;
}

// Times come in order, in all states or in none.
void CheckTime(const RecordedScene& before, const RecordedScene& scene) {
  if (before.time.has_value() != scene.time.has_value()) {
    throw InputError(scene.where + ": expected " +
                     (scene.time ? "no \"time\", as the states before have none, got one"
                                 : "a \"time\", as the states before have one, got none"));
  }
  if (scene.time && *scene.time < *before.time)
    throw InputError(scene.where + ": expected times in order, got one before that of the state before");
}

RecordedDemonstration FromStates(const std::string& text, const std::string& source) {
  std::istringstream in(text);
  const Demonstration demonstration = ReadDemonstration(in, source);
  const auto* poses = std::get_if<PoseDemonstration>(&demonstration);
  if (poses == nullptr)
    throw InputError(source +
                     ":1:1: expected poses of two models, got contact relations, which name no pose");
  RecordedDemonstration recording;
  recording.models = poses->models;
  for (const NamedPose& state : poses->states) {
    RecordedScene scene;
    scene.name = state.name;
    scene.where = state.where;
    scene.X_FM = joint::ToTransform(state.pose.pose);
    if (state.pose.exact) scene.exact = state.pose.pose;
    if (state.time) scene.time = algebra::ToDouble(*state.time);
    if (!recording.scenes.empty()) CheckTime(recording.scenes.back(), scene);
    recording.scenes.push_back(std::move(scene));
  }
  recording.description =
      "a demonstration in JSON, locations in " + std::string(ToString(poses->models.unit));
  return recording;
}

PoseLog ReadNamedLog(const JsonValue& name, const std::string& source, const PoseLogOptions& options) {
  const std::filesystem::path path(name.ReadString("the name of a pose log"));
  InputFile file((path.is_absolute() ? path : std::filesystem::path(source).parent_path() / path).string());
  return ReadPoseLog(file.stream(), file.name(), options);
}

PoseLogOptions ParseLogOptions(const JsonValue& logs) {
  PoseLogOptions options;
  if (const auto unit = logs.Find("unit")) options.unit = ParseLengthUnit(*unit);
  if (const auto order = logs.Find("quaternion")) {
    const std::string word = order->ReadString("\"xyzw\" or \"wxyz\"");
    if (word != "xyzw" && word != "wxyz") order->FailExpected("\"xyzw\" or \"wxyz\"");
    options.scalar_first = word == "wxyz";
  }
  return options;
}

std::optional<double> ParseTimeLimit(const JsonValue& logs) {
  const auto limit = logs.Find("time_limit");
  if (!limit) return std::nullopt;
  const algebra::Rational value = limit->ReadRational();
  if (value.sign() < 0) limit->FailExpected("seconds, not negative");
  return algebra::ToDouble(value);
}

RecordedDemonstration FromLogs(const JsonValue& root, const std::string& source) {
  root.ExpectObject({"moving", "fixed", "unit", "tolerance", "logs"});
  const JsonValue logs = root.At("logs");
  logs.ExpectObject({"moving", "fixed", "relative", "unit", "quaternion", "time_limit"});
  const bool relative = logs.Find("relative").has_value();
  if (relative && (logs.Find("moving") || logs.Find("fixed")))
    logs.Fail("expected logs of \"moving\" and \"fixed\", or one that is \"relative\", got both");
  RecordedDemonstration recording;
  recording.models = ParseCadModels(root, source);
  const PoseLogOptions options = ParseLogOptions(logs);
  const std::optional<double> limit = ParseTimeLimit(logs);
  std::vector<JsonValue> names = {logs.At(relative ? "relative" : "moving")};
  if (!relative) names.push_back(logs.At("fixed"));
  std::vector<PoseLog> read;
  for (const JsonValue& name : names) read.push_back(ReadNamedLog(name, source, options));
  const joint::PoseSeries series =
      relative ? joint::SeriesOf(read[0]) : joint::SeriesOf(read[0], read[1], limit);

  const double units = algebra::ToDouble(Ratio(LengthUnit::kMetre, recording.models.unit));
  const auto in_unit = [units](const Transform& X) { return Transform{X.R, units * X.p}; };
  for (size_t i = 0; i < series.poses.size(); ++i) {
    RecordedScene scene;
    scene.name = std::to_string(i + 1);
    if (!series.times.empty()) scene.time = series.times[i];
    scene.X_FM = in_unit(series.poses[i]);
    if (!series.X_WB.empty()) scene.X_CF = in_unit(series.X_WB[i]);
    scene.where = read[0].name + ":" + std::to_string(series.lines[i]) + ":1";
    recording.scenes.push_back(std::move(scene));
  }
  recording.notes = series.notes;
  for (const PoseLog& log : read) {
    recording.description += (recording.description.empty() ? "" : "; ") + log.description;
    recording.notes.insert(recording.notes.end(), log.notes.begin(), log.notes.end());
  }
  for (const std::string& doubt : joint::Suspicions(series)) recording.notes.push_back(doubt);
  return recording;
}

std::string Escaped(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    char code[8];
    if (static_cast<unsigned char>(c) < 0x20) {
      std::snprintf(code, sizeof code, "\\u%04x", c);
      out += code;
    } else {
      if (c == '"' || c == '\\') out += '\\';
      out += c;
    }
  }
  return out + "\"";
}

std::string Number(const algebra::Rational& value) {
  const std::string text = value.ToDecimal();
  return text.find('/') == std::string::npos ? text : "\"" + text + "\"";
}
std::string Number(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

std::string Vector(const algebra::Vector3& v) {
  return "[" + Number(v[0]) + "," + Number(v[1]) + "," + Number(v[2]) + "]";
}

std::string PoseText(const RecordedScene& scene) {
  if (scene.exact) {
    const auto& rows = scene.exact->rotation.rows;
    return "{\"t\":" + Vector(scene.exact->translation) + ",\"matrix\":[" + Vector(rows[0]) + "," +
           Vector(rows[1]) + "," + Vector(rows[2]) + "]}";
  }
  const Eigen::Quaterniond q(scene.X_FM.R);
  const Eigen::Vector3d& p = scene.X_FM.p;
  return "{\"t\":[" + Number(p.x()) + "," + Number(p.y()) + "," + Number(p.z()) + "],\"q\":[" +
         Number(q.w()) + "," + Number(q.x()) + "," + Number(q.y()) + "," + Number(q.z()) + "]}";
}

}  // namespace

RecordedDemonstration ReadRecording(std::istream& in, const std::string& source,
                                    const RecordingOptions& options) {
  const std::string text = ReadAll(in);
  const size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos)
    throw InputError(source + ":1:1: expected " + std::string(kForms) + ", got nothing");
  if (text[first] == 'N') {
    std::istringstream list(text);
    return FromList(list, source, options);
  }
  if (text[first] != '{') {
    SourceText{text, source}.Fail(first,
                                  "expected " + std::string(kForms) + ", got " +
                                      Quote(text.substr(first, text.find_first_of("\r\n", first) - first)));
  }
  std::istringstream stream(text);
  const auto document = JsonStream(stream, source).Next();
  const JsonValue root = document->root();
  return root.is_object() && root.Find("logs") ? FromLogs(root, source) : FromStates(text, source);
}

RecordedDemonstration ReadRecording(const std::string& path, const RecordingOptions& options) {
  InputFile file(path);
  return ReadRecording(file.stream(), file.name(), options);
}

std::string ToDemonstrationJson(const RecordedDemonstration& recording, const std::filesystem::path& folder) {
  const auto name = [&folder](const std::filesystem::path& path) {
    const std::filesystem::path near = std::filesystem::proximate(path, folder.empty() ? "." : folder);
    return Escaped(near.generic_string());
  };
  const CadModels& models = recording.models;
  std::string text = "{\"moving\":" + name(models.moving) + ",\"fixed\":" + name(models.fixed) +
                     ",\"unit\":\"" + std::string(ToString(models.unit)) +
                     "\",\"tolerance\":" + Number(models.tolerance) + ",\"states\":[";
  for (size_t i = 0; i < recording.scenes.size(); ++i) {
    const RecordedScene& scene = recording.scenes[i];
    text += (i == 0 ? "\n  {\"name\":" : ",\n  {\"name\":") + Escaped(scene.name);
    if (scene.time) text += ",\"time\":" + Number(*scene.time);
    text += ",\"pose\":" + PoseText(scene) + "}";
  }
  return text + "\n]}\n";
}

}  // namespace tact::input
