#include "robot/planning/ipopt_programme.h"

#define HAVE_CSTDDEF  // Ipopt's headers ask for it
#include <algorithm>
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpSolveStatistics.hpp>
#include <coin/IpTNLP.hpp>

#include "robot/planning/ipopt_lock.h"
#include "robot/planning/knot_jet.h"

namespace tact::planning {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using recognition::PointContact;

constexpr double kInfinity = 2e19;  // Ipopt's

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

}  // namespace

ProgrammeAnswer SolveByIpopt(const Programme& programme, Stage stage) {
  ProgrammeAnswer answer;
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
  answer.status = Words(status);
  const auto statistics = ipopt->Statistics();
  if (Ipopt::IsValid(statistics)) {
    Number dual = 0, primal = 0, complementarity = 0, kkt = 0;
    statistics->Infeasibilities(dual, primal, complementarity, kkt);
    answer.stationarity = dual;
    answer.iterations = statistics->IterationCount();
  }
  answer.numbers = nlp->answer;
  answer.solved = status == Ipopt::Solve_Succeeded || status == Ipopt::Solved_To_Acceptable_Level;
  return answer;
}

}  // namespace tact::planning
