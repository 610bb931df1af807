#include <fmt/format.h>

#include <cmath>

#include "cli/joint_text.h"
#include "cli/json_text.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

using joint::NamedParameter;
using joint::ParameterKind;

// JSON has no infinity; what is unknown is null.
std::string Number(double value) { return std::isfinite(value) ? fmt::format("{:.9g}", value) : "null"; }

template <typename Vector>
std::string Numbers(const Vector& values, int count) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) text += (i == 0 ? "" : ",") + Number(values[i]);
  return text + "]";
}

std::string KeyOf(const NamedParameter& parameter) {
  const char* frame = parameter.frame == joint::Link::kA   ? "_in_A"
                      : parameter.frame == joint::Link::kB ? "_in_B"
                                                           : "";
  return std::string(parameter.name) + frame;
}

std::string ParameterToJson(const NamedParameter& parameter) {
  std::string value, unit, error_unit;
  switch (parameter.kind) {
    case ParameterKind::kDirection:
      value = Numbers(parameter.value, 3), unit = "1", error_unit = "rad";
      break;
    case ParameterKind::kOrientation:
      value = Numbers(parameter.value, 4), unit = "1", error_unit = "rad";
      break;
    case ParameterKind::kPoint:
      value = Numbers(parameter.value, 3), unit = error_unit = "m";
      break;
    case ParameterKind::kLength:
      value = Number(parameter.value[0]), unit = error_unit = "m";
      break;
    case ParameterKind::kPitch:
      value = Number(parameter.value[0]), unit = error_unit = "m/rad";
      break;
  }
  const char* frame = parameter.frame == joint::Link::kA   ? "\"A\""
                      : parameter.frame == joint::Link::kB ? "\"B\""
                                                           : "null";
  return fmt::format(R"({{"value":{},"unit":"{}","frame":{},"error":{},"error_unit":"{}","determined":{}}})",
                     value, unit, frame, parameter.determined ? Number(parameter.expected_error) : "null",
                     error_unit, parameter.determined);
}

std::string CovarianceToJson(const NamedParameter& parameter) {
  if (!parameter.determined) return "null";
  std::string rows;
  for (int i = 0; i < 3; ++i) rows += (i == 0 ? "" : ",") + Numbers(parameter.covariance.row(i), 3);
  return "[" + rows + "]";
}

std::string Member(const std::string& key, const std::string& value) { return JsonString(key) + ":" + value; }

std::string TypeName(joint::JointType type) { return JsonString(std::string(NameOf(type))); }

std::string CoordinatesToJson(const JointAnswer& answer) {
  std::string text;
  const auto names = answer.type ? CoordinateNames(*answer.type) : std::vector<CoordinateName>{};
  for (size_t k = 0; k < names.size(); ++k) {
    const auto [least, most] = RangeOf(answer, k);
    text += fmt::format(R"({}{{"name":"{}","unit":"{}","least":{},"most":{}}})", k == 0 ? "" : ",",
                        names[k].name, names[k].angle ? "rad" : "m", Number(least), Number(most));
  }
  return "[" + text + "]";
}

}  // namespace

std::string JointToJson(const JointAnswer& answer) {
  const bool known = answer.type.has_value();
  const joint::JointFit& fit = answer.fit.fit;
  const int dof = known ? JointDof(*answer.type) : 0;
  const auto list = [](const auto& items, const auto& print) { return "[" + Join(items, ",", print) + "]"; };
  const auto object = [](const auto& items, const auto& print) {
    return "{" + Join(items, ",", print) + "}";
  };
  std::vector<std::string> members = {
      Member("type", known ? TypeName(*answer.type) : "\"undetermined\""),
      Member("reason", JsonString(answer.reason)),
      Member("parameters",
             object(answer.parameters, [](const auto& p) { return Member(KeyOf(p), ParameterToJson(p)); })),
      Member("covariance",
             object(answer.parameters, [](const auto& p) { return Member(KeyOf(p), CovarianceToJson(p)); })),
      Member("noise", known ? fmt::format(R"({{"rotation":{},"translation":{}}})", Number(fit.noise.rotation),
                                          Number(fit.noise.translation))
                            : "null"),
      Member("scores",
             object(answer.scores,
                    [](const auto& score) { return TypeName(score.type) + ":" + Number(score.bic); })),
      Member("candidates", list(answer.candidates, TypeName)),
      Member("poses", std::to_string(answer.series.poses.size())),
      Member("outliers", list(answer.fit.outliers, [](size_t pose) { return std::to_string(pose); })),
      Member("coordinates", CoordinatesToJson(answer)),
      Member("values", list(fit.coordinates, [dof](const auto& q) { return Numbers(q, dof); }))};
  if (answer.held_back) {
    members.push_back(Member("held_back", fmt::format(R"({{"rotation":{},"translation":{}}})",
                                                      list(answer.held_back->rotation, Number),
                                                      list(answer.held_back->translation, Number))));
  }
  members.push_back(Member("notes", list(answer.notes, JsonString)));
  return "{" + Join(members, ",", [](const std::string& member) { return member; }) + "}\n";
}

}  // namespace tact::cli
