#include "robot/planning/ipopt_plan.h"

#include <algorithm>
#include <cmath>

#include "robot/planning/angle_and_location.h"
#include "robot/planning/ipopt_programme.h"

namespace tact::planning {
namespace {

using Eigen::Vector3d;
using joint::Transform;
using recognition::PointContact;
using recognition::PointContactKind;

constexpr double kNear = 0.5;          // shares of the size: gaps of the guess below are watched
constexpr double kOpen = 1e-6;         // and above
constexpr double kIndependent = 1e-6;  // sine: rows nearer to the span of others are left out

// Contacts whose rows are independent in the pose, in order; of locations alone if only_locations.
Relation Independent(const Relation& relation, const SolidPair& solids, const Transform& X,
                     bool only_locations) {
  Relation kept;
  std::vector<Eigen::Matrix<double, 6, 1>> basis;
  for (const PointContact& contact : relation) {
    Eigen::Matrix<double, 6, 1> row = GapOf(contact, solids.moving_f, solids.fixed_f, X).row.transpose();
    // About the moving solid's origin, in its size.
    row.head<3>() = (row.head<3>() - X.p.cross(Vector3d(row.tail<3>()))) / solids.size;
    if (only_locations) row.head<3>().setZero();
    const double length = row.norm();
    for (int pass = 0; pass < 2; ++pass) {
      for (const auto& b : basis) row -= b.dot(row) * b;
    }
    if (row.norm() <= kIndependent * length) continue;
    basis.push_back(row.normalized());
    kept.push_back(contact);
  }
  return kept;
}

// Contacts to be kept from closing: C_e's, and vertices over faces, where they are open and near in the guess.
Relation OpenContacts(const ContactState& start, const ContactState& end, const SolidPair& solids,
                      const Transform& X) {
  Relation open;
  const auto add = [&](const PointContact& contact, bool of_end) {
    if (std::find(start.relation.begin(), start.relation.end(), contact) != start.relation.end()) return;
    const double gap = GapOf(contact, solids.moving_f, solids.fixed_f, X).gap / solids.size;
    if (gap < kOpen || gap > kNear) return;
    if (OffElements(contact, solids, X) > 0) return;
    if (of_end || std::find(end.relation.begin(), end.relation.end(), contact) == end.relation.end())
      open.push_back(contact);
  };
  for (const PointContact& contact : end.relation) add(contact, true);
  for (size_t v = 0; v < solids.moving_f.vertices.size(); ++v) {
    for (size_t f = 0; f < solids.fixed_f.faces.size(); ++f)
      add({PointContactKind::kVertexFace, v, f, 1}, false);
  }
  for (size_t f = 0; f < solids.moving_f.faces.size(); ++f) {
    for (size_t v = 0; v < solids.fixed_f.vertices.size(); ++v)
      add({PointContactKind::kFaceVertex, f, v, 1}, false);
  }
  return open;
}

Eigen::Matrix<double, 7, 1> Numbers(const Transform& X, double size, const Eigen::Vector4d& beside) {
  const Eigen::Quaterniond q(X.R);
  Eigen::Matrix<double, 7, 1> numbers;
  numbers << q.w(), q.x(), q.y(), q.z(), X.p / size;
  if (numbers.head<4>().dot(beside) < 0) numbers.head<4>() *= -1;
  return numbers;
}

Transform Between(const Transform& a, const Transform& b, double s) {
  return {joint::RotationExp(s * joint::RotationLog(b.R * a.R.transpose())) * a.R, a.p + s * (b.p - a.p)};
}

// Equal shares of the guess: of turning and of moving together.
std::vector<Transform> Guess(const ContactState& start, const ContactState& end, const Trajectory& closed,
                             double size, int knots) {
  std::vector<Transform> path;
  if (closed.failure.empty() && closed.samples.size() > 1) {
    for (const Sample& sample : closed.samples) path.push_back(sample.X_FM);
    if (closed.inverse) std::reverse(path.begin(), path.end());
  } else {
    path = {start.X_FM, end.X_FM};
  }
  std::vector<double> along = {0};
  for (size_t i = 1; i < path.size(); ++i)
    along.push_back(along.back() + (path[i].p - path[i - 1].p).norm() +
                    size * joint::RotationLog(path[i].R * path[i - 1].R.transpose()).norm());
  std::vector<Transform> guess;
  size_t i = 1;
  for (int k = 1; k <= knots; ++k) {
    const double at = along.back() * k / knots;
    while (i + 1 < path.size() && along[i] < at) ++i;
    const double length = along[i] - along[i - 1];
    guess.push_back(
        Between(path[i - 1], path[i], length > 0 ? std::min(1.0, (at - along[i - 1]) / length) : 1));
  }
  return guess;
}

// (A.19) at every knot: the turn from the start has no part about l; with the start's quaternion it is linear.
void ForbidTurns(const Basis& axes, const Eigen::Vector4d& s, KnotConstraints& knot) {
  const Vector3d v = s.tail<3>();
  for (const Vector3d& l : axes) {
    Linear linear{Eigen::Matrix<double, 7, 1>::Zero(), 0};
    linear.coefficients[0] = -l.dot(v);
    linear.coefficients.segment<3>(1) = s[0] * l - v.cross(l);
    knot.linear.push_back(linear);
  }
}

void ForbidShifts(const Basis& translations, const Vector3d& p, KnotConstraints& knot) {
  for (const Vector3d& l : translations) {
    Linear linear{Eigen::Matrix<double, 7, 1>::Zero(), l.dot(p)};
    linear.coefficients.tail<3>() = l;
    knot.linear.push_back(linear);
  }
}

Transform ToTransform(const double* numbers, double size) {
  const Eigen::Quaterniond q =
      Eigen::Quaterniond(numbers[0], numbers[1], numbers[2], numbers[3]).normalized();
  return {q.toRotationMatrix(), size * Vector3d(numbers[4], numbers[5], numbers[6])};
}

void Measure(const ContactState& start, const ContactState& end, const SolidPair& solids, IpoptPlan& plan) {
  for (size_t k = 0; k < plan.knots.size(); ++k) {
    const Transform& X = plan.knots[k];
    const Relation& held = k + 1 == plan.knots.size() ? end.relation : start.relation;
    plan.violation = std::max(plan.violation, ViolationOf(held, solids.moving_f, solids.fixed_f, X));
    plan.overlap = std::max(plan.overlap, OverlapIn(solids, X));
    if (k == 0) continue;
    plan.angle += joint::RotationLog(X.R * plan.knots[k - 1].R.transpose()).norm();
    plan.distance += (X.p - plan.knots[k - 1].p).norm();
  }
}

}  // namespace

double DistanceBetween(const std::vector<Transform>& path, const std::vector<Sample>& other, double size) {
  double farthest = 0;
  for (const Transform& X : path) {
    double nearest = HUGE_VAL;
    for (const Sample& sample : other)
      nearest =
          std::min(nearest, std::hypot((X.p - sample.X_FM.p).norm(),
                                       size * joint::RotationLog(X.R * sample.X_FM.R.transpose()).norm()));
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

IpoptPlan PlanByIpopt(const SolidPair& solids, const ContactState& given_start, const ContactState& given_end,
                      const Trajectory& closed, PathDefinition definition, int knots) {
  const ContactState &start = closed.inverse ? given_end : given_start,
                     &end = closed.inverse ? given_start : given_end;
  const std::vector<Transform> guess = Guess(start, end, closed, solids.size, knots);
  const auto rows = [&](const ContactState& state) {
    return MotionRowsOf(state.relation, solids.moving_f, solids.fixed_f, state.X_FM, solids.size,
                        state.ranks);
  };
  const MotionRows start_rows = rows(start), end_rows = rows(end);
  Programme programme{solids, Numbers(start.X_FM, solids.size, Eigen::Vector4d(1, 0, 0, 0)), {}, {}};
  Eigen::Vector4d beside = programme.first.head<4>();
  for (int k = 1; k <= knots; ++k) {
    const Transform& X = guess[static_cast<size_t>(k - 1)];
    const bool last = k == knots;
    KnotConstraints knot;
    knot.equal = last ? Independent(end.relation, solids, end.X_FM, false)
                      : Independent(start.relation, solids, start.X_FM, false);
    if (!last) knot.open = OpenContacts(start, end, solids, X);
    if (definition == PathDefinition::kThesis) {
      if (start_rows.ranks.rotation < end_rows.ranks.rotation)
        ForbidTurns(end_rows.axes, programme.first.head<4>(), knot);
      else if (last)
        ForbidShifts(end_rows.translations, start.X_FM.p / solids.size, knot);
    }
    programme.knots.push_back(knot);
    const auto numbers = Numbers(X, solids.size, beside);
    beside = numbers.head<4>();
    programme.guess.insert(programme.guess.end(), numbers.data(), numbers.data() + kNumbers);
  }
  IpoptPlan plan;
  std::vector<double> answer = programme.guess;
  const auto solve = [&](Stage stage) {
    const ProgrammeAnswer found = SolveByIpopt(programme, stage);
    plan.status = found.status;
    plan.stationarity = std::max(plan.stationarity, found.stationarity);
    plan.iterations += found.iterations;
    if (!found.numbers.empty()) answer = found.numbers;
    return found.solved;
  };
  plan.solved = solve(Stage::kRotation);
  if (plan.solved) {
    programme.guess = answer;
    for (int k = 0; k < knots; ++k) {
      // With the orientations kept only locations are unknown: fewer equations are independent, and (A.19) is settled.
      KnotConstraints& knot = programme.knots[static_cast<size_t>(k)];
      const bool last = k + 1 == knots;
      const Transform X = ToTransform(answer.data() + kNumbers * k, solids.size);
      knot.equal = Independent(last ? end.relation : start.relation, solids, X, true);
      std::erase_if(knot.linear, [](const Linear& linear) { return linear.coefficients.tail<3>().isZero(); });
    }
    plan.solved = solve(Stage::kTranslation);
  }
  plan.knots.push_back(start.X_FM);
  for (int k = 0; k < knots; ++k)
    plan.knots.push_back(ToTransform(answer.data() + kNumbers * k, solids.size));
  Measure(start, end, solids, plan);
  if (plan.solved && plan.overlap > 0) plan.status += ", but the solids overlap on the way";
  if (closed.inverse) std::reverse(plan.knots.begin(), plan.knots.end());
  if (closed.failure.empty()) plan.apart = DistanceBetween(plan.knots, closed.samples, solids.size);
  return plan;
}

}  // namespace tact::planning
