#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "cli/plan_answer.h"

namespace tact::cli {
namespace {

constexpr double kDegree = 180 / std::numbers::pi;
constexpr double kNothing = 1e-8;  // radian or shares of the size: what Ipopt leaves of a motion that is none

using Rows = std::vector<std::vector<std::string>>;

std::string Name(const PlanAnswer& answer, const PlanAnswer::Step& step) {
  const auto& states = answer.demonstration.states;
  return states[step.planned.from].name + " -> " + states[step.planned.to].name;
}

std::string Axis(const Eigen::Vector3d& a) {
  const auto clean = [](double x) { return std::abs(x) < 5e-5 ? 0.0 : x; };
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", clean(a.x()), clean(a.y()), clean(a.z()));
}

// How much more the closed form costs; "-" where both are nothing.
std::string Ratio(double closed, double ipopt, double nothing) {
  if (ipopt <= nothing) return closed <= nothing ? "-" : "only Ipopt has none";
  return fmt::format("{:.7f}", closed / ipopt);
}

std::string Table(const Rows& rows) {
  std::vector<size_t> widths(rows[0].size(), 0);
  for (const auto& row : rows) {
    for (size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (size_t i = 0; i < row.size(); ++i) line += fmt::format("{:<{}}  ", row[i], widths[i]);
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

}  // namespace

std::vector<std::string> PlanHeader(const PlanAnswer& answer) {
  const std::string unit(ToString(answer.demonstration.unit));
  return {"transition", "case", "axis", "angle [deg]", "distance [" + unit + "]", "violation [" + unit + "]",
          "failure"};
}

std::vector<std::string> PlanCells(const PlanAnswer& answer, const PlanAnswer::Step& step) {
  const planning::Trajectory& t = step.planned.trajectory;
  std::string axes;
  for (const planning::Segment& segment : t.segments) {
    if (!segment.is_turn()) continue;
    axes += (axes.empty() ? "" : ", then ") + Axis(segment.turn.axis);
  }
  const std::string& failure = step.planned.failure();
  return {Name(answer, step),
          CaseText(t),
          axes.empty() ? "-" : axes,
          fmt::format("{:.6g}", t.angle * kDegree),
          fmt::format("{:.6g}", t.distance),
          fmt::format("{:.1e}", t.violation),
          failure.empty() ? "-" : failure};
}

std::vector<std::string> IpoptHeader(const PlanAnswer& answer) {
  const std::string unit(ToString(answer.demonstration.unit));
  return {"transition",
          "optimum",
          "angle [deg]",
          "closed/Ipopt",
          "distance [" + unit + "]",
          "closed/Ipopt",
          "apart [" + unit + "]",
          "violation",
          "stationarity",
          "overlap",
          "status"};
}

std::vector<std::string> IpoptCells(const PlanAnswer& answer, const PlanAnswer::Step& step,
                                    size_t definition) {
  const planning::Trajectory& t = step.planned.trajectory;
  const planning::IpoptPlan& p = step.ipopt[definition];
  const bool both = t.failure.empty() && p.solved;
  return {Name(answer, step),
          definition == 0 ? "least" : "thesis",
          fmt::format("{:.6g}", p.angle < kNothing ? 0 : p.angle * kDegree),
          both ? Ratio(t.angle, p.angle, kNothing * 10) : "-",
          fmt::format("{:.6g}", p.distance),
          both ? Ratio(t.distance, p.distance, kNothing * answer.demonstration.solids.size) : "-",
          both ? fmt::format("{:.3g}", p.apart) : "-",
          fmt::format("{:.1e}", p.violation),
          fmt::format("{:.1e}", p.stationarity),
          fmt::format("{:.3g}", p.overlap),
          p.status};
}

std::string PlanText(const PlanAnswer& answer) {
  Rows rows = {PlanHeader(answer)}, ipopt = {IpoptHeader(answer)};
  std::string notes;
  for (const PlanAnswer::Step& step : answer.steps) {
    rows.push_back(PlanCells(answer, step));
    for (const std::string& note : step.planned.trajectory.notes)
      notes += "note on " + Name(answer, step) + ": " + note + "\n";
    for (size_t i = 0; i < step.ipopt.size(); ++i) ipopt.push_back(IpoptCells(answer, step, i));
  }
  std::string text = "closed form, in the fixed model's frame\n" + Table(rows) + notes;
  if (ipopt.size() > 1)
    text += "\nIpopt: rotation first, then translation; by the thesis' definition (A.10), (A.19) too\n" +
            Table(ipopt);
  return text;
}

}  // namespace tact::cli
