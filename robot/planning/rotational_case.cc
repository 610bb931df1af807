#include "robot/planning/rotational_case.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace tact::planning {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kDegree = 180 / std::numbers::pi;
constexpr double kNoAngle = 1e-12;  // radian: rounding of two equal orientations' quotient
// Sine between an axis and the space it should be in: an axis of a turn by 1e-4 radian from exact poses is that sure.
constexpr double kAxisTolerance = 1e-9;

std::string Degrees(double angle) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g degrees", angle * kDegree);
  return text;
}

double Angle(double sine) { return std::asin(std::min(1.0, std::abs(sine))); }

void Add(TurnAnswer& answer, const Turn& turn) {
  if (std::abs(turn.angle) <= kNoAngle) return;
  answer.turns.push_back(turn.angle > 0 ? turn : Turn{-turn.axis, -turn.angle});
  answer.least_angle += std::abs(turn.angle);
}

void DirectTurn(const TurnProblem& problem, const Matrix3d& D, TurnAnswer& answer) {
  const Vector3d log = joint::RotationLog(D);
  const double angle = log.norm();
  if (angle <= kNoAngle) return;
  const Vector3d axis = log / angle;
  const double off = PartOutside(problem.start_axes, axis).norm();
  if (off * angle > kAxisTolerance) {
    answer.failure = "the end's orientation asks for a turn about an axis that is " + Degrees(Angle(off)) +
                     " off the solution space of (A.16): no turn about one axis maintains the relation";
    return;
  }
  Add(answer, {axis, angle});
}

void ToFixedOrientation(const TurnProblem& problem, const Matrix3d& D, TurnAnswer& answer) {
  answer.number = 1;
  const LineContact& line = problem.start_line;
  if (problem.start.rotation != 1 || !line) return DirectTurn(problem, D, answer);
  answer.cure = std::string("A.6.1 ") + ToString(line.kind);
  const auto split = SplitIntoTwo(D, line.carried(), line.staying());
  if (!split) {
    answer.failure = std::string(line.kind == LineContactKind::kEdgeFace ? "(A.24)" : "(A.25)") +
                     " has no solution: at the end the edge of the " + ToString(line.kind) + " contact is " +
                     Degrees(Angle(line.staying().dot(D * line.carried()))) + " off the face's plane";
    return;
  }
  Add(answer, split->first);
  Add(answer, split->second);
}

void ToOneAxis(const TurnProblem& problem, const Matrix3d& D, TurnAnswer& answer) {
  answer.number = 2;
  Add(answer, SplitAboutAndAcross(D, problem.end_axes[0]).across_first);
}

void BetweenAxes(const TurnProblem& problem, const Matrix3d& D, TurnAnswer& answer) {
  answer.number = 3;
  const Vector3d& a1 = problem.end_axes[0];
  const double off = PartOutside(problem.start_axes, a1).norm();
  Vector3d a2;
  if (off <= kAxisTolerance) {
    const Vector3d normal = problem.start_axes[0].cross(problem.start_axes[1]);
    a2 = normal.cross(a1).normalized();
  } else if (problem.start_line) {
    answer.cure = std::string("A.6.2 ") + ToString(problem.start_line.kind);
    a2 = problem.start_line.n;
  } else {
    answer.failure = "the bases cannot be shared: the end's axis is " + Degrees(Angle(off)) +
                     " off the start's axes, and the start is no single edge-face or face-edge contact";
    return;
  }
  const auto split = SplitIntoTwo(D, a2, a1);
  if (!split) {
    answer.failure =
        "(A.21) has no solution: the turns about a_1 and a_2 do not make up the difference of the "
        "orientations, by " +
        Degrees(std::abs(Angle(a1.dot(D * a2)) - Angle(a1.dot(a2))));
    return;
  }
  Add(answer, split->first);
}

void ToTwoAxes(const TurnProblem& problem, const Matrix3d& D, TurnAnswer& answer) {
  answer.number = 4;
  const LineContact& line = problem.end_line;
  if (!line) {
    const Vector3d a3 = problem.end_axes[0].cross(problem.end_axes[1]);
    return Add(answer, {a3, SplitAboutAndAcross(D, a3).about});
  }
  answer.cure = std::string("A.6.1 ") + ToString(line.kind);
  // What the solid carries has to come across what stays.
  const Vector3d carried = D.transpose() * line.carried();
  Add(answer, TurnIntoPlane(carried, line.staying(), line.staying().cross(line.carried()).normalized()));
  answer.least_angle = Angle(carried.dot(line.staying()));
}

}  // namespace

TurnAnswer RotationalCase(const TurnProblem& problem) {
  TurnAnswer answer;
  const Matrix3d D = problem.R_end * problem.R_start.transpose();
  const int from = problem.start.rotation, to = problem.end.rotation;
  if (from >= to) return answer;
  if (to == 3) {
    ToFixedOrientation(problem, D, answer);
  } else if (to == 2) {
    from == 0 ? ToOneAxis(problem, D, answer) : BetweenAxes(problem, D, answer);
  } else {
    ToTwoAxes(problem, D, answer);
  }
  return answer;
}

}  // namespace tact::planning
