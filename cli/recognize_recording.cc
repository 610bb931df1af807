#include "cli/recognize_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <sstream>

#include "algebra/error.h"
#include "cli/json_text.h"
#include "cli/output.h"
#include "cli/recognition_text.h"
#include "provers/report/html.h"
#include "provers/report/solid_drawing.h"
#include "provers/report/state_graph.h"
#include "provers/report/text.h"
#include "robot/input/json_stream.h"
#include "robot/input/recorded_demonstration.h"
#include "robot/input/rotation_quaternion.h"
#include "robot/recognition/recorded_recognition.h"
#include "robot/recognition/recording_summary.h"

namespace tact::cli {
namespace {

using input::RecordedDemonstration;
using recognition::RecognizedScene;
using recognition::RecordedRecognition;
using recognition::SceneCandidate;
using recognition::SeenRelation;

constexpr double kDegrees = 180 / std::numbers::pi;

struct Answer {
  RecordedDemonstration recording;
  recognition::ModelPair models;
  RecordedRecognition recognized;
  bool noise_given = false;
};

const SceneCandidate& Chosen(const RecognizedScene& scene) { return scene.candidates[scene.chosen]; }

// The relation of each recognized scene, from 0.
std::vector<size_t> RelationOfScene(const RecordedRecognition& recognized) {
  std::vector<size_t> relation;
  for (const RecognizedScene& scene : recognized.scenes) {
    const size_t before = relation.empty() ? 0 : relation.back();
    relation.push_back(scene.number > recognized.recognition.relations[before].last ? before + 1 : before);
  }
  return relation;
}

// Of a relation's scenes the one whose pose had to change least, in units of the noise.
const RecognizedScene& ClearestScene(const RecordedRecognition& recognized, const SeenRelation& relation) {
  const RecognizedScene* clearest = nullptr;
  double least = 0;
  for (const RecognizedScene& scene : recognized.scenes) {
    if (scene.number < relation.first || scene.number > relation.last) continue;
    const double change = std::hypot(Chosen(scene).turned / recognized.noise.rotation,
                                     Chosen(scene).moved / recognized.noise.location);
    if (clearest != nullptr && change >= least) continue;
    clearest = &scene;
    least = change;
  }
  return *clearest;
}

// A rational quaternion of an exact rotation, by the largest of its four squares.
std::array<algebra::Rational, 4> QuaternionOf(const algebra::Rotation& R) {
  const auto& r = R.rows;
  const algebra::Rational trace = r[0].x + r[1].y + r[2].z;
  const std::array<algebra::Rational, 4> squares = {1 + trace, 1 + 2 * r[0].x - trace, 1 + 2 * r[1].y - trace,
                                                    1 + 2 * r[2].z - trace};
  const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
  const algebra::Rational wx = r[2].y - r[1].z, wy = r[0].z - r[2].x, wz = r[1].x - r[0].y,
                          xy = r[0].y + r[1].x, xz = r[0].z + r[2].x, yz = r[1].z + r[2].y;
  if (largest == 0) return {squares[0], wx, wy, wz};
  if (largest == 1) return {wx, squares[1], xy, xz};
  if (largest == 2) return {wy, xy, squares[2], yz};
  return {wz, xz, yz, squares[3]};
}

std::string PoseToJson(const algebra::Pose& X) {
  std::string text = R"({"t":)" + ToJson(X.translation) + R"(,"q":[)";
  const auto q = QuaternionOf(X.rotation);
  for (size_t i = 0; i < 4; ++i) text += (i == 0 ? "" : ",") + ToJson(q[i]);
  return text + "]}";
}

std::string NoiseText(const Answer& answer) {
  return fmt::format("errors of {:.2f} degrees and {:.2f} {} a component ({})",
                     answer.recognized.noise.rotation * kDegrees, answer.recognized.noise.location,
                     ToString(answer.models.unit), answer.noise_given ? "as given" : "estimated");
}

std::string SceneRange(const SeenRelation& relation) {
  return std::to_string(relation.first) +
         (relation.last > relation.first ? "-" + std::to_string(relation.last) : "");
}

std::string StepText(const RecordedRecognition& recognized, const recognition::RejectedTransition& step) {
  return "scene " + recognized.scenes[step.scene - 1].name + " to " + recognized.scenes[step.scene].name +
         ": " + ToString(step.validity);
}

constexpr const char* kGaps = "between these scenes more happened than they show";
constexpr const char* kRejected =
    "steps between the scenes' own most plausible relations that no motion makes";

std::string ToText(const Answer& answer) {
  const RecordedRecognition& recognized = answer.recognized;
  std::string text = fmt::format("{}; {}\n", answer.recording.description, NoiseText(answer)) +
                     cli::ToText(recognized.recognition);
  const auto relation = RelationOfScene(recognized);
  text += fmt::format("\nwhat the poses had to change\n{:<8}{:<10}{:>12}{:>12}{:>14}\n", "scene", "relation",
                      "turned", "moved", "candidates");
  for (size_t k = 0; k < recognized.scenes.size(); ++k) {
    const RecognizedScene& scene = recognized.scenes[k];
    text += fmt::format("{:<8}{:<10}{:>8.2f} deg{:>9.2f} {}{:>14}\n", scene.name,
                        recognized.recognition.relations[relation[k]].name, Chosen(scene).turned * kDegrees,
                        Chosen(scene).moved, ToString(answer.models.unit), scene.candidates.size());
  }
  const auto list = [&](const char* title, const std::vector<recognition::RejectedTransition>& steps) {
    if (!steps.empty()) text += std::string("\n") + title + "\n";
    for (const auto& step : steps) text += "  " + StepText(recognized, step) + "\n";
  };
  list(kGaps, recognized.gaps);
  list(kRejected, recognized.rejected);
  return text;
}

std::string ToJson(const Answer& answer) {
  const RecordedRecognition& recognized = answer.recognized;
  std::string text =
      "{" + ToJsonMembers(recognized.recognition) +
      fmt::format(R"(,"noise":{{"rotation":{},"location":{},"unit":"{}","estimated":{}}},"scenes":[)",
                  recognized.noise.rotation, recognized.noise.location, ToString(answer.models.unit),
                  !answer.noise_given);
  const auto relation = RelationOfScene(recognized);
  for (size_t k = 0; k < recognized.scenes.size(); ++k) {
    const RecognizedScene& scene = recognized.scenes[k];
    text +=
        fmt::format(R"({}{{"name":{},"relation":{},"pose":{},"turned":{},"moved":{},"candidates":{}}})",
                    k == 0 ? "" : ",", JsonString(scene.name), relation[k], PoseToJson(Chosen(scene).X_FM),
                    Chosen(scene).turned, Chosen(scene).moved, scene.candidates.size());
  }
  const auto list = [&](const char* name, const std::vector<recognition::RejectedTransition>& steps) {
    text += std::string("],\"") + name + "\":[";
    for (size_t i = 0; i < steps.size(); ++i) {
      text += fmt::format(R"({}{{"scene":{},"why":{}}})", i == 0 ? "" : ",",
                          recognized.scenes[steps[i].scene].number, JsonString(ToString(steps[i].validity)));
    }
  };
  list("gaps", recognized.gaps);
  list("rejected", recognized.rejected);
  return text + "]}\n";
}

void WriteStates(const Answer& answer, const std::string& path) {
  const input::CadModels& models = answer.recording.models;
  std::string text = R"({"moving":)" + JsonString(std::filesystem::absolute(models.moving).string()) +
                     R"(,"fixed":)" + JsonString(std::filesystem::absolute(models.fixed).string()) +
                     R"(,"unit":")" + std::string(ToString(answer.models.unit)) +
                     R"(","tolerance":0,"states":[)";
  const auto& relations = answer.recognized.recognition.relations;
  for (size_t i = 0; i < relations.size(); ++i) {
    const RecognizedScene& scene = ClearestScene(answer.recognized, relations[i]);
    text += std::string(i == 0 ? "" : ",") + "\n  {\"name\":" + JsonString(relations[i].name) +
            ",\"pose\":" + PoseToJson(Chosen(scene).X_FM) + "}";
  }
  WriteFile(path, text + "\n]}\n");
}

algebra::Pose Rounded(const joint::Transform& X) {
  const auto exact = [](double value) { return algebra::Rational::FromShortestDecimal(value); };
  const Eigen::Quaterniond q(X.R);
  return {algebra::Rotation::FromQuaternion(exact(q.w()), exact(q.x()), exact(q.y()), exact(q.z())),
          {exact(X.p.x()), exact(X.p.y()), exact(X.p.z())}};
}

std::string Picture(const Answer& answer, const RecognizedScene& scene) {
  const SceneCandidate& chosen = Chosen(scene);
  return provers::DrawContactRelation(
      {{Transform(answer.models.moving, chosen.X_FM), provers::Part::kMoving},
       {Transform(answer.models.moving, Rounded(scene.seen_FM)), provers::Part::kOutline},
       {answer.models.fixed, provers::Part::kFixed}},
      chosen.found.relation);
}

// The different relations in order; what was seen, and what else would be valid, or is rejected by its DOF-transitions.
std::string StateGraph(const Answer& answer) {
  const auto& relations = answer.recognized.recognition.relations;
  std::vector<const SeenRelation*> states;
  std::vector<size_t> state_of;  // each relation
  for (const SeenRelation& relation : relations) {
    const auto same = std::find_if(states.begin(), states.end(), [&](const SeenRelation* other) {
      return recognition::SameElements(other->primitives, relation.primitives);
    });
    state_of.push_back(static_cast<size_t>(same - states.begin()));
    if (same == states.end()) states.push_back(&relation);
  }
  std::vector<provers::StateEdge> edges;
  std::set<std::pair<size_t, size_t>> seen;
  for (size_t i = 0; i + 1 < state_of.size(); ++i) {
    if (state_of[i] != state_of[i + 1] && seen.emplace(state_of[i], state_of[i + 1]).second)
      edges.push_back({state_of[i], state_of[i + 1], provers::StateLink::kSeen});
  }
  std::vector<std::string> names;
  for (size_t i = 0; i < states.size(); ++i) {
    names.push_back("Scenes " + SceneRange(*states[i]) + "\n" + ContactSummary(*states[i]));
    for (size_t j = i + 1; j < states.size(); ++j) {
      const auto validity = recognition::ValidityOf({states[i]->primitives, states[i]->dof},
                                                    {states[j]->primitives, states[j]->dof},
                                                    answer.models.moving, answer.models.fixed);
      if (!validity.included || seen.contains({i, j}) || seen.contains({j, i})) continue;
      edges.push_back(
          {i, j, validity.practical ? provers::StateLink::kValid : provers::StateLink::kRejected});
    }
  }
  return DrawStateGraph(names, edges);
}

void WritePage(const Answer& answer, const std::string& path) {
  const RecordedRecognition& recognized = answer.recognized;
  const auto& relations = recognized.recognition.relations;
  std::string html = "<h1>What was done</h1>\n<p class=\"lead\">" +
                     provers::Escape(answer.recording.description) + "; " +
                     provers::Escape(NoiseText(answer)) +
                     ".</p>\n<p>Solid where the moving object is in contact, dotted where it was seen.</p>\n";
  html += provers::FigureHtml(
      {"Contact relations: blue what was seen; grey what would be valid, too, one including the "
       "other; red and crossed out what its DOF-transitions rule out.",
       StateGraph(answer)},
      "states");
  for (size_t i = 0; i < relations.size(); ++i) {
    const SeenRelation& relation = relations[i];
    html += fmt::format("<h2>Scenes {}</h2>\n", SceneRange(relation));
    const RecognizedScene& clearest = ClearestScene(recognized, relation);
    const SceneCandidate& chosen = Chosen(clearest);
    html += provers::FigureHtml(
        {fmt::format("Scene {}: turned by {:.2f} degrees and moved by {:.2f} {} into contact.", clearest.name,
                     chosen.turned * kDegrees, chosen.moved, ToString(answer.models.unit)),
         Picture(answer, clearest)},
        "relation-" + std::to_string(i));
    if (i + 1 == relations.size()) break;
    const algebra::Transition& t = recognized.recognition.transitions[i];
    html += std::string("<p>Then") + (t.critical ? ", critically" : "") + ": ";
    for (size_t k = 0; k < t.sub_skills.size(); ++k)
      html += (k == 0 ? "" : ", ") + provers::Escape(ToString(t.sub_skills[k]));
    html += std::string(t.sub_skills.empty() ? "no sub-skill" : "") + ".</p>\n<p class=\"small\">" +
            provers::Escape(t.why) + "</p>\n";
  }
  const auto list = [&](std::string title, const std::vector<recognition::RejectedTransition>& steps) {
    if (steps.empty()) return;
    html += "<p>" + title + ":</p>\n<ul>\n";
    for (const auto& step : steps) html += "<li>" + provers::Escape(StepText(recognized, step)) + "</li>\n";
    html += "</ul>\n";
  };
  list("Between these scenes more happened than they show", recognized.gaps);
  list("Steps between the scenes&#39; own most plausible relations that no motion makes",
       recognized.rejected);
  html += "<h2>Every scene</h2>\n";
  for (size_t k = 0; k < recognized.scenes.size(); ++k) {
    html += provers::FigureHtml({"Scene " + recognized.scenes[k].name, Picture(answer, recognized.scenes[k])},
                                "scene-" + std::to_string(k));
  }
  WriteFile(path, provers::PageHtml("What was done", html));
}

}  // namespace

bool IsRecording(const RecognizeOptions& options) {
  if (options.noisy || !options.noise.empty()) return true;
  if (options.file == "-") return false;
  input::InputFile file(options.file);
  file.stream() >> std::ws;
  if (file.stream().peek() != '{') return file.stream().peek() == 'N';
  const std::string text((std::istreambuf_iterator<char>(file.stream())), {});
  return text.find("\"logs\"") != text.npos;
}

ExitStatus RunRecognizeRecording(const RecognizeOptions& options) {
  input::RecordingOptions reading;
  if (!options.unit.empty()) {
    reading.unit = cad::ParseLengthUnit(options.unit);
    if (!reading.unit) throw InputError("--unit: expected mm, cm, m or in, got " + options.unit);
  }
  Answer answer;
  answer.recording = input::ReadRecording(options.file, reading);
  answer.models = recognition::LoadModels(answer.recording.models);
  std::vector<recognition::NamedTransform> scenes;
  for (const input::RecordedScene& scene : answer.recording.scenes)
    scenes.push_back({scene.name, scene.X_FM});
  recognition::RecordingSearch search;
  answer.noise_given = !options.noise.empty();
  for (const double noise : options.noise)
    if (!(noise > 0 && std::isfinite(noise)))
      throw InputError(
          fmt::format("--noise: expected two numbers above zero, degrees and a length, got {}", noise));
  if (answer.noise_given) search.noise = {options.noise[0] / kDegrees, options.noise[1]};
  answer.recognized = RecognizeRecording(answer.models, scenes, search);
  for (const std::string& note : answer.recording.notes) Note(note);
  const recognition::RecordingSummary summary =
      Summarise(answer.recording, recognition::ProximitySolid(answer.models.moving),
                recognition::ProximitySolid(answer.models.fixed));
  for (const std::string& doubt : summary.doubts) Note(doubt);
  for (const std::string& note : answer.recognized.recognition.notes) Note(note);
  const size_t skipped = answer.recognized.skipped.size();
  for (const std::string& scene : answer.recognized.skipped)
    Note("scene " + scene + " is left out: the solids overlap there deeper than the errors explain");
  if (3 * skipped > answer.recording.scenes.size())
    Note(fmt::format(
        "{} of {} scenes are left out: are the models swapped, or the poses' frame or unit wrong?", skipped,
        answer.recording.scenes.size()));
  if (!options.states.empty()) WriteStates(answer, options.states);
  if (!options.page.empty()) WritePage(answer, options.page);
  Output output;
  output << (options.json ? ToJson(answer) : ToText(answer));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
