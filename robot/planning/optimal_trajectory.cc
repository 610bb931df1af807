#include "robot/planning/optimal_trajectory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "robot/planning/angle_and_location.h"

namespace tact::planning {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using joint::Transform;

// A displacement's share that F_s does not allow: rounding of a line over a hundredth of the size.
constexpr double kOffStart = 1e-9;

std::string Number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

// Forward: no fewer restricted DOFs at the end.
class Planner {
 public:
  Planner(const SolidPair& solids, const ContactState& start, const ContactState& end, int steps)
      : solids_(solids), start_(start), end_(end), steps_(std::max(1, steps)) {}

  Trajectory Plan(const MotionRows& start, const MotionRows& end) {
    answer_.start = start.ranks;
    answer_.end = end.ranks;
    Add(start_.X_FM, start_.relation);
    if (start.ranks.rotation < end.ranks.rotation) {
      answer_.turns = RotationalCase({start_.X_FM.R, end_.X_FM.R, start.ranks, end.ranks, start.axes,
                                      end.axes, Line(start_), Line(end_)});
      answer_.failure = answer_.turns.failure;
      for (const Turn& turn : answer_.turns.turns) {
        if (answer_.failure.empty()) Rotate(turn);
      }
    }
    if (answer_.failure.empty()) Translate(start.ranks, end.ranks);
    if (answer_.failure.empty()) Finish();
    return std::move(answer_);
  }

 private:
  const Transform& here() const { return answer_.samples.back().X_FM; }

  LineContact Line(const ContactState& state) const {
    return LineContactOf(state.relation, solids_.moving, solids_.fixed, solids_.moving_f, solids_.fixed_f,
                         state.X_FM);
  }

  double Violation(const Relation& relation, const Transform& X_FM) const {
    return ViolationOf(relation, solids_.moving_f, solids_.fixed_f, X_FM);
  }

  bool TooMuch(double violation) const { return violation > kViolationTolerance * solids_.size; }

  void Add(const Transform& X_FM, const Relation& relation) {
    answer_.samples.push_back({X_FM, Violation(relation, X_FM), false});
  }

  void Rotate(const Turn& turn) {
    const Transform from = here();
    Segment segment{turn, Vector3d::Zero(), answer_.samples.size() - 1, 0};
    for (int k = 1; k <= steps_ && answer_.failure.empty(); ++k) {
      const Matrix3d R = joint::RotationExp(turn.angle * k / steps_ * turn.axis) * from.R;
      const Location location =
          NearestLocation(start_.relation, solids_.moving_f, solids_.fixed_f, R, here().p);
      answer_.samples.push_back({{R, location.p}, location.violation, false});
      if (TooMuch(location.violation)) {
        answer_.failure =
            "(A.23) has no solution: turned by " + Number(turn.angle * k / steps_ * 180 / std::numbers::pi) +
            " degrees, gaps of the maintained relation of " + Number(location.violation) + " remain";
      }
    }
    segment.last = answer_.samples.size() - 1;
    segment.displacement = here().p - from.p;
    answer_.segments.push_back(segment);
  }

  void Translate(const Ranks& start_ranks, const Ranks& end_ranks) {
    const Transform from = here();
    const Location end =
        NearestLocation(end_.relation, solids_.moving_f, solids_.fixed_f, from.R, end_.X_FM.p);
    if (TooMuch(end.violation)) {
      const double off = joint::RotationLog(end_.X_FM.R * from.R.transpose()).norm() * 180 / std::numbers::pi;
      answer_.failure = "no location satisfies the other contact relation with the orientation reached, " +
                        Number(off) + " degrees from the one given: gaps of " + Number(end.violation) +
                        " remain";
      return;
    }
    const auto rows = [&](const Relation& relation, const Vector3d& p, const Ranks& ranks) {
      return MotionRowsOf(relation, solids_.moving_f, solids_.fixed_f, {from.R, p}, solids_.size, ranks);
    };
    // The number of independent normals is that of the given pose: where normals turned into one another, F has
    // less and what is missing shows as a failure.
    const Straight line = TranslationalCase(from.p, end.p, rows(start_.relation, from.p, start_ranks),
                                            rows(end_.relation, end.p, end_ranks));
    answer_.straight = line.number;
    const double length = line.displacement.norm();
    if (length <= kNoMotion * solids_.size) return;
    if (line.off_start * length > kOffStart * solids_.size) {
      answer_.failure =
          "no straight path maintains the contact relation: the line of the translational case leaves it "
          "by " +
          Number(line.off_start) + " of its length";
      return;
    }
    Segment segment{{}, line.displacement, answer_.samples.size() - 1, 0};
    for (int k = 1; k <= steps_; ++k)
      Add({from.R, from.p + static_cast<double>(k) / steps_ * line.displacement}, start_.relation);
    segment.last = answer_.samples.size() - 1;
    answer_.segments.push_back(segment);
  }

  // The last sample is the other relation's.
  void Finish() {
    Sample& last = answer_.samples.back();
    last.violation = Violation(end_.relation, last.X_FM);
    last.at_other = true;
    if (TooMuch(last.violation))
      answer_.failure = "the line does not end where the other contact relation holds: gaps of " +
                        Number(last.violation) + " remain";
  }

  const SolidPair& solids_;
  const ContactState &start_, &end_;
  int steps_;
  Trajectory answer_;
};

void Invert(Trajectory& t) {
  t.inverse = true;
  std::swap(t.start, t.end);
  std::reverse(t.samples.begin(), t.samples.end());
  std::reverse(t.segments.begin(), t.segments.end());
  const size_t last = t.samples.size() - 1;
  for (Segment& segment : t.segments) {
    std::swap(segment.first, segment.last);
    segment.first = last - segment.first;
    segment.last = last - segment.last;
    segment.displacement = -segment.displacement;
    segment.turn.axis = -segment.turn.axis;
  }
}

void Measure(Trajectory& t) {
  for (size_t i = 0; i < t.samples.size(); ++i) {
    t.violation = std::max(t.violation, t.samples[i].violation);
    if (i > 0) t.distance += (t.samples[i].X_FM.p - t.samples[i - 1].X_FM.p).norm();
  }
  for (const Segment& segment : t.segments) t.angle += std::abs(segment.turn.angle);
}

}  // namespace

SolidPair MakeSolidPair(const algebra::Polyhedron& moving, const algebra::Polyhedron& fixed) {
  SolidPair pair{moving, fixed, recognition::ToDouble(moving), recognition::ToDouble(fixed), 0};
  pair.size = SizeOf(pair.moving_f);
  return pair;
}

Trajectory PlanOptimalTrajectory(const SolidPair& solids, const ContactState& start, const ContactState& end,
                                 int steps) {
  const auto rows = [&](const ContactState& state) {
    return MotionRowsOf(state.relation, solids.moving_f, solids.fixed_f, state.X_FM, solids.size,
                        state.ranks);
  };
  const MotionRows s = rows(start), e = rows(end);
  const int turn = e.ranks.rotation - s.ranks.rotation, shift = e.ranks.translation - s.ranks.translation;
  const bool inverse = turn < 0 || (turn == 0 && shift < 0);
  Trajectory answer =
      inverse ? Planner(solids, end, start, steps).Plan(e, s) : Planner(solids, start, end, steps).Plan(s, e);
  if (inverse) Invert(answer);
  if (turn * shift < 0)
    answer.notes.push_back("the restricted DOFs go opposite ways, in translation " +
                           std::to_string(s.ranks.translation) + " to " +
                           std::to_string(e.ranks.translation) + " and in rotation " +
                           std::to_string(s.ranks.rotation) + " to " + std::to_string(e.ranks.rotation) +
                           ", which A.2 excludes");
  if (turn == 0 && shift == 0)
    answer.notes.push_back("the restricted DOFs do not change, which Table A.1 leaves out");
  Measure(answer);
  return answer;
}

std::string CaseText(const Trajectory& t) {
  std::string text;
  if (t.turns.number > 0) {
    text = "rotational " + std::to_string(t.turns.number);
    if (!t.turns.cure.empty()) text += ", " + t.turns.cure;
  }
  if (t.straight > 0) text += (text.empty() ? "" : " + ") + ("translational " + std::to_string(t.straight));
  if (text.empty()) text = "none";
  return t.inverse ? text + ", inverse" : text;
}

}  // namespace tact::planning
