#include "robot/planning/ipopt_plan.h"

#define HAVE_CSTDDEF  // Ipopt's headers ask for it
#include <algorithm>
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpSolveStatistics.hpp>
#include <coin/IpTNLP.hpp>

#include "robot/planning/angle_and_location.h"
#include "robot/planning/ipopt_lock.h"
#include "robot/planning/knot_jet.h"

namespace tact::planning {
namespace {

using Eigen::Vector3d;
using Ipopt::Index;
using Ipopt::Number;
using joint::Transform;
using recognition::PointContact;
using recognition::PointContactKind;

constexpr Index kNumbers = 7;          // of a knot
constexpr double kNear = 0.5;          // shares of the size: gaps of the guess below are watched
constexpr double kOpen = 1e-6;         // and above
constexpr double kIndependent = 1e-6;  // sine: rows nearer to the span of others are left out
constexpr double kInfinity = 2e19;     // Ipopt's

enum class Stage { kRotation, kTranslation };

struct Linear {  // of one knot: coefficients . numbers = value
  Eigen::Matrix<double, 7, 1> coefficients;
  double value = 0;
};

struct KnotConstraints {
  Relation equal, open;
  std::vector<Linear> linear;
};

struct Programme {
  const SolidPair& solids;
  Eigen::Matrix<double, 7, 1> first;   // q_0
  std::vector<KnotConstraints> knots;  // of q_1 ... q_K
  std::vector<double> guess;           // their numbers
};

// One solve. In the second stage the quaternions are fixed by their bounds.
class KnotProgramme : public Ipopt::TNLP {
 public:
  KnotProgramme(const Programme& programme, Stage stage) : p_(programme), stage_(stage) {}

  std::vector<double> answer;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    const Index K = static_cast<Index>(p_.knots.size());
    n = kNumbers * K;
    m = 0;
    jacobian = 0;
    for (const KnotConstraints& knot : p_.knots) {
      const Index rows = Rows(knot);
      m += rows;
      jacobian += kNumbers * rows;
    }
    hessian = 28 * K + kNumbers * (K - 1);
    style = TNLP::C_STYLE;
    return true;
  }

  bool get_bounds_info(Index n, Number* low, Number* high, Index, Number* g_low, Number* g_high) override {
    for (Index i = 0; i < n; ++i) {
      const bool kept = stage_ == Stage::kTranslation && i % kNumbers < 4;
      low[i] = kept ? p_.guess[static_cast<size_t>(i)] : -kInfinity;
      high[i] = kept ? low[i] : kInfinity;
    }
    Index row = 0;
    for (const KnotConstraints& knot : p_.knots) {
      if (stage_ == Stage::kRotation) g_low[row] = g_high[row] = 1, ++row;
      for (size_t i = 0; i < knot.equal.size(); ++i, ++row) g_low[row] = g_high[row] = 0;
      for (size_t i = 0; i < knot.open.size(); ++i, ++row) g_low[row] = 0, g_high[row] = kInfinity;
      for (const Linear& linear : knot.linear) g_low[row] = g_high[row] = linear.value, ++row;
    }
    return true;
  }

  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy_n(p_.guess.begin(), n, x);
    return true;
  }

  bool eval_f(Index, const Number* x, bool, Number& f) override {
    f = 0;
    ForEachStep(x, [&](Index, Index, double step) { f += Weight() * step * step; });
    return true;
  }

  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    std::fill_n(gradient, n, 0.0);
    ForEachStep(x, [&](Index before, Index after, double step) {
      if (before >= 0) gradient[before] -= 2 * Weight() * step;
      gradient[after] += 2 * Weight() * step;
    });
    return true;
  }

  bool eval_g(Index, const Number* x, bool, Index, Number* g) override {
    ForEachRow(x, [&](Index row, Index, const Jet& jet) { g[row] = jet.value; });
    return true;
  }

  bool eval_jac_g(Index, const Number* x, bool, Index, Index, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      Index at = 0, row = 0;
      for (size_t k = 0; k < p_.knots.size(); ++k) {
        for (Index i = Rows(p_.knots[k]); i > 0; --i, ++row) {
          for (Index c = 0; c < kNumbers; ++c, ++at) {
            rows[at] = row;
            columns[at] = kNumbers * static_cast<Index>(k) + c;
          }
        }
      }
      return true;
    }
    ForEachRow(x, [&](Index row, Index, const Jet& jet) {
      for (Index c = 0; c < kNumbers; ++c) values[kNumbers * row + c] = jet.gradient[c];
    });
    return true;
  }

  bool eval_h(Index, const Number* x, bool, Number factor, Index, const Number* lambda, bool, Index count,
              Index* rows, Index* columns, Number* values) override {
    const Index K = static_cast<Index>(p_.knots.size());
    if (values == nullptr) {
      Index at = 0;
      for (Index k = 0; k < K; ++k) {
        for (Index i = 0; i < kNumbers; ++i) {
          for (Index j = 0; j <= i; ++j, ++at) rows[at] = kNumbers * k + i, columns[at] = kNumbers * k + j;
        }
      }
      for (Index i = kNumbers; i < kNumbers * K; ++i, ++at) rows[at] = i, columns[at] = i - kNumbers;
      return true;
    }
    std::fill_n(values, count, 0.0);
    ForEachRow(x, [&](Index row, Index k, const Jet& jet) {
      Index at = 28 * k;
      for (Index i = 0; i < kNumbers; ++i) {
        for (Index j = 0; j <= i; ++j, ++at) values[at] += lambda[row] * jet.hessian(i, j);
      }
    });
    const double twice = 2 * factor * Weight();
    ForEachStep(x, [&](Index before, Index after, double) {
      values[Diagonal(after)] += twice;
      if (before < 0) return;
      values[Diagonal(before)] += twice;
      values[28 * K + before] -= twice;
    });
    return true;
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    answer.assign(x, x + n);
  }

 private:
  static Index Diagonal(Index variable) {
    const Index i = variable % kNumbers;
    return 28 * (variable / kNumbers) + i * (i + 1) / 2 + i;
  }

  Index Rows(const KnotConstraints& knot) const {
    return static_cast<Index>(knot.equal.size() + knot.open.size() + knot.linear.size()) +
           (stage_ == Stage::kRotation ? 1 : 0);
  }

  // The sum of squared steps times the number of steps is a squared length.
  double Weight() const { return static_cast<double>(p_.knots.size()); }

  // visit(variable before, variable after, difference) of what the stage counts; before is -1 for q_0.
  template <typename Visit>
  void ForEachStep(const Number* x, const Visit& visit) const {
    const Index begin = stage_ == Stage::kRotation ? 0 : 4, end = stage_ == Stage::kRotation ? 4 : kNumbers;
    for (Index k = 0; k < static_cast<Index>(p_.knots.size()); ++k) {
      for (Index i = begin; i < end; ++i) {
        const Index after = kNumbers * k + i, before = after - kNumbers;
        visit(before, after, x[after] - (k == 0 ? p_.first[i] : x[before]));
      }
    }
  }

  template <typename Visit>
  void ForEachRow(const Number* x, const Visit& visit) const {
    Index row = 0;
    for (size_t k = 0; k < p_.knots.size(); ++k) {
      const KnotConstraints& knot = p_.knots[k];
      const Number* numbers = x + kNumbers * static_cast<Index>(k);
      const KnotJets jets(numbers);
      const Index index = static_cast<Index>(k);
      if (stage_ == Stage::kRotation)
        visit(row++, index,
              jets.q[0] * jets.q[0] + jets.q[1] * jets.q[1] + jets.q[2] * jets.q[2] + jets.q[3] * jets.q[3]);
      for (const Relation* relation : {&knot.equal, &knot.open}) {
        for (const PointContact& contact : *relation)
          visit(row++, index, GapJet(contact, p_.solids.moving_f, p_.solids.fixed_f, p_.solids.size, jets));
      }
      for (const Linear& linear : knot.linear) {
        Jet jet;
        for (Index i = 0; i < kNumbers; ++i) jet.value += linear.coefficients[i] * numbers[i];
        jet.gradient = linear.coefficients;
        visit(row++, index, jet);
      }
    }
  }

  const Programme& p_;
  Stage stage_;
};

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

const char* Words(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "solved";
    case Ipopt::Solved_To_Acceptable_Level:
      return "solved to an acceptable level";
    case Ipopt::Infeasible_Problem_Detected:
      return "no feasible path found";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "too many iterations";
    case Ipopt::Restoration_Failed:
      return "feasibility could not be restored";
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return "more equations than unknowns";
    default:
      return "stopped by Ipopt";
  }
}

bool Solve(const Programme& programme, Stage stage, IpoptPlan& plan, std::vector<double>& numbers) {
  Ipopt::SmartPtr<KnotProgramme> nlp = new KnotProgramme(programme, stage);
  const auto lock = LockIpopt();
  Ipopt::SmartPtr<Ipopt::IpoptApplication> ipopt = IpoptApplicationFactory();
  const auto options = ipopt->Options();
  options->SetIntegerValue("print_level", 0);
  options->SetStringValue("sb", "yes");
  options->SetNumericValue("tol", 1e-10);
  options->SetNumericValue("constr_viol_tol", 1e-11);
  options->SetIntegerValue("max_iter", 300);
  options->SetStringValue("fixed_variable_treatment", "make_parameter");
  options->SetNumericValue("bound_relax_factor", 1e-10);
  ipopt->Initialize();
  const auto status = ipopt->OptimizeTNLP(Ipopt::SmartPtr<Ipopt::TNLP>(Ipopt::GetRawPtr(nlp)));
  plan.status = Words(status);
  const auto statistics = ipopt->Statistics();
  if (Ipopt::IsValid(statistics)) {
    Number dual = 0, primal = 0, complementarity = 0, kkt = 0;
    statistics->Infeasibilities(dual, primal, complementarity, kkt);
    plan.stationarity = std::max(plan.stationarity, dual);
    plan.iterations += statistics->IterationCount();
  }
  if (!nlp->answer.empty()) numbers = nlp->answer;
  return status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level;
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
  plan.solved = Solve(programme, Stage::kRotation, plan, answer);
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
    plan.solved = Solve(programme, Stage::kTranslation, plan, answer);
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
