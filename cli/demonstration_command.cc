#include <fmt/format.h>

#include <filesystem>
#include <numbers>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/json_text.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "robot/input/resample.h"
#include "robot/perception/vision_noise.h"
#include "robot/recognition/contact_estimation.h"
#include "robot/recognition/posed_models.h"
#include "robot/recognition/recording_summary.h"

namespace tact::cli {
namespace {

using input::RecordedDemonstration;
using recognition::EstimationRule;
using recognition::NearContact;
using recognition::PointContact;
using recognition::RecordingSummary;

constexpr double kDegree = 180 / std::numbers::pi;

RecordedDemonstration Read(const DemonstrationOptions& options) {
  input::RecordingOptions reading;
  if (!options.unit.empty()) {
    reading.unit = cad::ParseLengthUnit(options.unit);
    if (!reading.unit)
      throw InputError("--unit: expected mm, cm, m or in, the unit of locations, got " + options.unit);
  }
  RecordedDemonstration recording = input::ReadRecording(options.file, reading);
  if (options.every) recording = EveryKth(recording, static_cast<size_t>(*options.every));
  if (options.scenes) recording = AtEvenTimes(recording, static_cast<size_t>(*options.scenes));
  if (options.noise) {
    const double unit = ToDouble(Ratio(cad::LengthUnit::kMillimetre, recording.models.unit));
    recording = perception::MakeNoisy(
        std::move(recording), {options.degrees / kDegree, options.millimetres * unit}, *options.noise);
  }
  return recording;
}

std::string ToJson(const PointContact& contact) { return JsonString(ToString(contact)); }

std::string ToJson(const std::vector<NearContact>& near, const std::string& name) {
  return R"({"name":)" + JsonString(name) + R"(,"near":[)" +
         Join(near, ",",
              [](const NearContact& n) {
                return fmt::format(R"({{"contact":{},"gap":{:.9g},"aside":{:.9g}}})", ToJson(n.contact),
                                   n.gap, n.aside);
              }) +
         "]}";
}

struct Answer {
  RecordedDemonstration recording;
  RecordingSummary summary;
  EstimationRule rule;
  std::vector<std::vector<NearContact>> estimates;  // if asked for, one a scene
};

std::string ToJsonLine(const Answer& answer) {
  const input::CadModels& models = answer.recording.models;
  const RecordingSummary& s = answer.summary;
  std::string text = fmt::format(
      R"({{"moving":{},"fixed":{},"unit":"{}","scenes":{},"times":{},"low":[{:.9g},{:.9g},{:.9g}],)"
      R"("high":[{:.9g},{:.9g},{:.9g}],"path":{:.9g},"turn":{:.9g},"noise":{:.9g},"threshold":{:.9g},"why":{})",
      JsonString(models.moving.generic_string()), JsonString(models.fixed.generic_string()),
      ToString(models.unit), answer.recording.scenes.size(), answer.recording.scenes.front().time.has_value(),
      s.low.x(), s.low.y(), s.low.z(), s.high.x(), s.high.y(), s.high.z(), s.path, s.turn, answer.rule.noise,
      answer.rule.threshold, JsonString(answer.rule.why));
  if (!answer.estimates.empty()) {
    text += R"(,"contacts":[)";
    for (size_t i = 0; i < answer.estimates.size(); ++i)
      text += (i == 0 ? "" : ",") + ToJson(answer.estimates[i], answer.recording.scenes[i].name);
    text += "]";
  }
  return text + "}\n";
}

std::string ContactLines(const Answer& answer) {
  std::string text =
      "\nscene       contacts within the threshold, and their gaps; tact recognize says which hold "
      "together\n";
  for (size_t i = 0; i < answer.estimates.size(); ++i) {
    const std::vector<NearContact>& near = answer.estimates[i];
    text += fmt::format("{:<12}", answer.recording.scenes[i].name) +
            (near.empty() ? "none"
                          : Join(near, ", ",
                                 [](const NearContact& n) {
                                   return ToString(n.contact) + fmt::format(" {:+.3g}", n.gap);
                                 })) +
            "\n";
  }
  return text;
}

std::string ToText(const Answer& answer) {
  const input::CadModels& models = answer.recording.models;
  const auto& scenes = answer.recording.scenes;
  const RecordingSummary& s = answer.summary;
  const std::string unit(ToString(models.unit));
  std::string text = "moving    " + models.moving.generic_string() + "\nfixed     " +
                     models.fixed.generic_string() + "\nfrom      " + answer.recording.description + "\n";
  text += fmt::format("scenes    {}", scenes.size());
  if (scenes.front().time && scenes.back().time)
    text += fmt::format(", {:.6g} s", *scenes.back().time - *scenes.front().time);
  text += fmt::format(
      "\nlocation  x {:.4g} to {:.4g}, y {:.4g} to {:.4g}, z {:.4g} to {:.4g} {}, of the moving model's "
      "origin in the "
      "fixed one's frame\n"
      "motion    {:.4g} {} in all, turned by up to {:.3g} degrees\n",
      s.low.x(), s.high.x(), s.low.y(), s.high.y(), s.low.z(), s.high.z(), unit, s.path, unit,
      kDegree * s.turn);
  text += "contacts  " + answer.rule.why + "\n";
  return text + (answer.estimates.empty() ? "" : ContactLines(answer));
}

}  // namespace

ExitStatus RunDemonstration(const DemonstrationOptions& options) {
  Answer answer;
  answer.recording = Read(options);
  const recognition::ModelPair models = recognition::LoadModels(answer.recording.models);
  const recognition::ProximitySolid moving(models.moving), fixed(models.fixed);
  answer.summary = Summarise(answer.recording, moving, fixed);
  answer.rule = MakeRule(answer.recording, moving, fixed, {std::nullopt, options.threshold});
  if (options.contacts) {
    for (const input::RecordedScene& scene : answer.recording.scenes)
      answer.estimates.push_back(EstimateContacts(moving, fixed, scene.X_FM, answer.rule.threshold));
  }
  const std::vector<std::string>* const all[] = {&answer.recording.notes, &models.notes,
                                                 &answer.summary.doubts};
  for (const auto* notes : all) {
    for (const std::string& note : *notes) Note(note);
  }
  if (!options.output.empty()) {
    WriteFile(options.output,
              ToDemonstrationJson(answer.recording, std::filesystem::path(options.output).parent_path()));
  }
  Output output;
  output << (options.json ? ToJsonLine(answer) : ToText(answer));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
