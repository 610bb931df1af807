#include <fmt/format.h>

#include "cli/json_text.h"
#include "cli/plan_answer.h"

namespace tact::cli {
namespace {

std::string Vector(const Eigen::Vector3d& v) {
  return fmt::format("[{:.15g},{:.15g},{:.15g}]", v.x(), v.y(), v.z());
}

std::string PoseMembers(const joint::Transform& X) {
  const Eigen::Quaterniond q(X.R);
  return fmt::format(R"("t":{},"q":[{:.15g},{:.15g},{:.15g},{:.15g}])", Vector(X.p), q.w(), q.x(), q.y(),
                     q.z());
}

std::string TextOrNull(const std::string& text) { return text.empty() ? "null" : JsonString(text); }

template <typename List, typename Write>
std::string Array(const List& list, const Write& write) {
  std::string text = "[";
  for (size_t i = 0; i < list.size(); ++i) text += (i == 0 ? "" : ",") + write(i);
  return text + "]";
}

std::string SegmentJson(const planning::Segment& s) {
  const std::string motion = s.is_turn() ? fmt::format(R"("kind":"turn","axis":{},"angle":{:.15g})",
                                                       Vector(s.turn.axis), s.turn.angle)
                                         : R"("kind":"line")";
  return fmt::format(R"({{{},"displacement":{},"first":{},"last":{}}})", motion, Vector(s.displacement),
                     s.first, s.last);
}

std::string IpoptJson(const planning::IpoptPlan& p, size_t definition) {
  return fmt::format(
      R"({{"definition":"{}","solved":{},"status":{},"angle":{:.15g},"distance":{:.15g},"violation":{:.3g},)"
      R"("stationarity":{:.3g},"overlap":{:.6g},"apart":{:.6g},"iterations":{},"knots":{}}})",
      definition == 0 ? "least" : "thesis", p.solved, JsonString(p.status), p.angle, p.distance, p.violation,
      p.stationarity, p.overlap, p.apart, p.iterations,
      Array(p.knots, [&](size_t i) { return "{" + PoseMembers(p.knots[i]) + "}"; }));
}

std::string StepJson(const PlanAnswer& answer, const PlanAnswer::Step& step) {
  const planning::Trajectory& t = step.planned.trajectory;
  const auto& states = answer.demonstration.states;
  const auto sample = [&](size_t i) {
    return fmt::format(R"({{{},"violation":{:.3g},"overlap":{:.6g}}})", PoseMembers(t.samples[i].X_FM),
                       t.samples[i].violation, step.planned.check.overlaps[i]);
  };
  return fmt::format(
      R"({{"from":{},"to":{},"restricted":[[{},{}],[{},{}]],"case":{},"rotational":{},"cure":{},"translational":{},)"
      R"("inverse":{},"angle":{:.15g},"least_angle":{:.15g},"distance":{:.15g},"violation":{:.3g},"overlap":{:.6g},)"
      R"("failure":{},"notes":{},"segments":{},"samples":{},"ipopt":{}}})",
      JsonString(states[step.planned.from].name), JsonString(states[step.planned.to].name),
      t.start.translation, t.start.rotation, t.end.translation, t.end.rotation, JsonString(CaseText(t)),
      t.turns.number, TextOrNull(t.turns.cure), t.straight, t.inverse, t.angle, t.turns.least_angle,
      t.distance, t.violation, step.planned.check.overlap, TextOrNull(step.planned.failure()),
      Array(t.notes, [&](size_t i) { return JsonString(t.notes[i]); }),
      Array(t.segments, [&](size_t i) { return SegmentJson(t.segments[i]); }), Array(t.samples, sample),
      Array(step.ipopt, [&](size_t i) { return IpoptJson(step.ipopt[i], i); }));
}

}  // namespace

std::string PlanJson(const PlanAnswer& answer) {
  return fmt::format(R"({{"unit":"{}","transitions":{}}})", ToString(answer.demonstration.unit),
                     Array(answer.steps, [&](size_t i) { return StepJson(answer, answer.steps[i]); })) +
         "\n";
}

}  // namespace tact::cli
