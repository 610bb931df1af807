#include "cli/joint_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

using joint::Link;
using joint::NamedParameter;
using joint::ParameterKind;

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr size_t kMostLines = 12;  // of outliers that are named

double InUnit(double metres, cad::LengthUnit unit) {
  return metres * ToDouble(Ratio(cad::LengthUnit::kMetre, unit));
}

// As many decimals as make a tenth of a millimetre visible.
std::string Length(double metres, cad::LengthUnit unit) {
  const int decimals = unit == cad::LengthUnit::kMetre ? 4 : unit == cad::LengthUnit::kMillimetre ? 1 : 2;
  const double value = InUnit(metres, unit);
  return fmt::format("{:.{}f}", std::abs(value) < 0.5 * std::pow(10, -decimals) ? 0 : value, decimals);
}

std::string Numbers(const Eigen::Vector4d& value, int count, double scale, int decimals) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    const double number = scale * value[i];
    text += fmt::format("{:10.{}f}", std::abs(number) < 0.5 * std::pow(10, -decimals) ? 0 : number, decimals);
  }
  return text;
}

std::string Degrees(double radian) { return fmt::format("{:.2g} deg", radian * kDegrees); }

std::string ShortLength(double metres, cad::LengthUnit unit) {
  const cad::LengthUnit small = SmallUnit(unit);
  return fmt::format("{:.2g} {}", InUnit(metres, small), ToString(small));
}

JointRow RowOf(const JointAnswer& answer, const NamedParameter& parameter, cad::LengthUnit unit) {
  JointRow row;
  row.name = ParameterName(*answer.type, parameter);
  row.frame = parameter.frame == Link::kNeither ? "" : parameter.frame == Link::kA ? "in A" : "in B";
  const double scale = InUnit(1, unit);
  const int decimals = unit == cad::LengthUnit::kMetre ? 4 : unit == cad::LengthUnit::kMillimetre ? 1 : 2;
  const std::string name(ToString(unit));
  switch (parameter.kind) {
    case ParameterKind::kDirection:
      row.value = Numbers(parameter.value, 3, 1, 5);
      row.error = Degrees(parameter.expected_error);
      break;
    case ParameterKind::kOrientation:
      row.value = Numbers(parameter.value, 4, 1, 5);
      row.error = Degrees(parameter.expected_error);
      break;
    case ParameterKind::kPoint:
      row.value = Numbers(parameter.value, 3, scale, decimals) + " " + name;
      row.error = ShortLength(parameter.expected_error, unit);
      break;
    case ParameterKind::kLength:
      row.value = Numbers(parameter.value, 1, scale, decimals) + " " + name;
      row.error = ShortLength(parameter.expected_error, unit);
      break;
    case ParameterKind::kPitch: {
      const double turn = 2 * std::numbers::pi;
      row.value = Numbers(parameter.value, 1, turn * scale, decimals + 1) + " " + name + " a turn";
      row.error = ShortLength(turn * parameter.expected_error, unit);
      break;
    }
  }
  row.error = parameter.determined ? "+- " + row.error : "left open by the poses";
  return row;
}

double Quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<size_t>(share * static_cast<double>(values.size())))];
}

}  // namespace

cad::LengthUnit SmallUnit(cad::LengthUnit unit) {
  return unit == cad::LengthUnit::kInch ? unit : cad::LengthUnit::kMillimetre;
}

std::vector<JointRow> ParameterRows(const JointAnswer& answer, cad::LengthUnit unit) {
  std::vector<JointRow> rows;
  for (const NamedParameter& parameter : answer.parameters) rows.push_back(RowOf(answer, parameter, unit));
  // The first axis, which is B's, before the second.
  for (size_t i = 1; answer.type == joint::JointType::kTwoAxis && i < rows.size(); ++i) {
    if (rows[i].frame == "in B" && rows[i - 1].frame == "in A") std::swap(rows[i], rows[i - 1]);
  }
  return rows;
}

std::vector<std::string> CoordinateRanges(const JointAnswer& answer, cad::LengthUnit unit) {
  std::vector<std::string> ranges;
  const auto names = CoordinateNames(*answer.type);
  for (size_t k = 0; k < names.size(); ++k) {
    const auto [least, most] = RangeOf(answer, k);
    ranges.push_back(names[k].angle ? fmt::format("{} from {:.1f} to {:.1f} deg", names[k].name,
                                                  least * kDegrees, most * kDegrees)
                                    : fmt::format("{} from {} to {} {}", names[k].name, Length(least, unit),
                                                  Length(most, unit), ToString(unit)));
  }
  return ranges;
}

std::string NoiseText(const JointAnswer& answer, cad::LengthUnit unit) {
  const joint::NoiseScale& noise = answer.fit.fit.noise;
  return Degrees(noise.rotation) + " and " + ShortLength(noise.translation, unit) + ", a component";
}

std::string HeldBackText(const JointAnswer& answer, cad::LengthUnit unit) {
  const joint::PoseErrors& errors = *answer.held_back;
  const auto within = [&](double share) {
    return Degrees(Quantile(errors.rotation, share)) + " and " +
           ShortLength(Quantile(errors.translation, share), unit);
  };
  return "half within " + within(0.5) + ", 95 % within " + within(0.95);
}

std::vector<std::vector<std::string>> ScoreRows(const JointAnswer& answer) {
  std::vector<const joint::TypeScore*> scores;
  for (const joint::TypeScore& score : answer.scores) scores.push_back(&score);
  std::stable_sort(scores.begin(), scores.end(),
                   [](const auto* a, const auto* b) { return a->bic < b->bic; });
  std::vector<std::vector<std::string>> rows;
  for (const joint::TypeScore* score : scores) {
    rows.push_back({std::string(NameOf(score->type)), std::to_string(score->parameters),
                    fmt::format("{:.1f}", score->bic),
                    fmt::format("{:.1f}", score->bic - scores.front()->bic),
                    score->plausible ? "plausible" : ""});
  }
  return rows;
}

std::string JointTitle(const JointAnswer& answer) {
  const std::string poses =
      std::to_string(answer.series.poses.size()) + (answer.series.poses.size() == 1 ? " pose" : " poses");
  if (!answer.type) return "undetermined: " + poses + " cannot tell the type of joint";
  return std::string(NameOf(*answer.type)) + " joint, from " + poses;
}

std::string OutlierLines(const JointAnswer& answer) {
  const auto& outliers = answer.fit.outliers;
  std::string text = outliers.size() == 1 ? "line " : "lines ";
  for (size_t k = 0; k < outliers.size() && k < kMostLines; ++k)
    text += (k == 0 ? "" : ", ") + std::to_string(answer.series.lines[outliers[k]]);
  if (outliers.size() > kMostLines) text += fmt::format(" and {} more", outliers.size() - kMostLines);
  return text;
}

std::string JointToText(const JointAnswer& answer, cad::LengthUnit unit) {
  std::string text = JointTitle(answer) + "\n";
  const auto line = [&text](std::string_view name, std::string_view value) {
    text += fmt::format("  {:<30}{}\n", name, value);
  };
  for (const JointRow& row : ParameterRows(answer, unit))
    text += fmt::format("  {:<30}{:<5}{:<44}{}\n", row.name, row.frame, row.value, row.error);
  if (answer.type) {
    for (const std::string& range : CoordinateRanges(answer, unit)) line("moved through", range);
    line("noise", NoiseText(answer, unit));
    if (!answer.fit.outliers.empty()) line("wrong poses set aside", OutlierLines(answer));
    if (answer.held_back) line("poses held back", HeldBackText(answer, unit));
  }
  line("why", answer.reason);
  if (answer.scores.empty()) return text;
  text += fmt::format("\n  {:<12}{:>10}{:>12}{:>16}\n", "type", "parameters", "BIC", "above the best");
  for (const auto& row : ScoreRows(answer)) {
    text += fmt::format("  {:<12}{:>10}{:>12}{:>16}{}\n", row[0], row[1], row[2], row[3],
                        row[4].empty() ? "" : "  " + row[4]);
  }
  return text;
}

}  // namespace tact::cli
