#include "robot/correction/nearest_pose_ipopt.h"

#include <Eigen/Geometry>
#define HAVE_CSTDDEF  // Ipopt's headers ask for it
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpIpoptCalculatedQuantities.hpp>
#include <coin/IpIpoptData.hpp>
#include <coin/IpSolveStatistics.hpp>
#include <coin/IpTNLP.hpp>

#include "algebra/error.h"
#include "robot/planning/ipopt_lock.h"

namespace tact::correction {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;
using Ipopt::Index;
using Ipopt::Number;
using joint::Transform;

constexpr int kPose = 7, kPlane = 4,
              kLocal = kPose + kPlane;  // variables: of the pose, of a pair's plane, of both
constexpr double kNear =
    0.5;  // pairs farther apart at the start than this, times the models' size, get no plane
constexpr double kSmall = 1e-5;  // squared tangent of half a turn below which its series serves
using LocalJet = Jet<kLocal>;

LocalJet Square(const LocalJet& a) { return a * a; }

// 4 atan(sqrt z)^2: the squared turn, from the squared tangent of its half.
LocalJet SquaredTurn(const LocalJet& z) {
  const double x = z.value;
  if (x < kSmall)
    return Chain(z, 4 * x * (1 - 2 * x / 3), 4 * (1 - 4 * x / 3 + 23 * x * x / 15),
                 4 * (-4.0 / 3 + 46 * x / 15));
  const double root = std::sqrt(x), angle = std::atan(root), above = 1 + x;
  return Chain(z, 4 * angle * angle, 4 * angle / (root * above),
               2 * (1 / x - angle * (1 + 3 * x) / (root * x)) / (above * above));
}

// Variables are laid out w, x, y, z of the quaternion, the place, then each pair's plane: normal, offset.
class Nlp : public Ipopt::TNLP {
 public:
  Nlp(const Models& models, const Relation& relation, const Transform& X0, const Transform& start,
      const Metric& metric)
      : size_(models.size),
        length_(metric.LengthFor(models) / models.size),
        reference_(metric.reference / size_),
        seen_(X0.R),
        seen_at_(X0 * metric.reference / size_) {
    const NearestPose ours(models, relation, metric);
    for (const Feature& feature : ours.equalities()) features_.push_back(Scaled(feature));
    equalities_ = features_.size();
    for (const auto& contact : relation.contacts)
      for (const Feature& feature : WithinFeatures(contact, models, start))
        features_.push_back(Scaled(feature));
    const Eigen::Quaterniond q(start.R);
    const Vector3d at = start * metric.reference / size_;
    x_.resize(kPose);
    x_ << q.w(), q.vec(), at;
    for (const ConvexPiece& a : models.moving.pieces)
      for (const ConvexPiece& b : models.fixed.pieces) AddPair(a, b, start);
  }
  Transform Pose() const {
    const Eigen::Matrix3d R = Eigen::Quaterniond(x_[0], x_[1], x_[2], x_[3]).normalized().toRotationMatrix();
    return {R, size_ * (x_.segment<3>(4) - R * reference_)};
  }
  double infeasibility = 0, stationarity = 0;

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian, IndexStyleEnum& style) override {
    n = static_cast<Index>(x_.size());
    m = Rows();
    jacobian = n * m;
    hessian = n * (n + 1) / 2;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index n, Number* low, Number* high, Index m, Number* row_low,
                       Number* row_high) override {
    std::fill(low, low + n, -2e19);
    std::fill(high, high + n, 2e19);
    std::fill(row_low, row_low + m, 0);
    std::fill(row_high, row_high + m, 2e19);
    std::fill(row_high, row_high + 1 + equalities_ + pairs_.size(), 0);
    return true;
  }
  bool get_starting_point(Index n, bool, Number* x, bool, Number*, Number*, Index, bool, Number*) override {
    std::copy(x_.data(), x_.data() + n, x);
    return true;
  }
  bool eval_f(Index, const Number* x, bool, Number& value) override {
    value = Objective(x).value;
    return true;
  }
  bool eval_grad_f(Index n, const Number* x, bool, Number* gradient) override {
    std::fill(gradient, gradient + n, 0);
    const LocalJet objective = Objective(x);
    std::copy(objective.gradient.data(), objective.gradient.data() + kPose, gradient);
    return true;
  }
  bool eval_g(Index, const Number* x, bool, Index, Number* values) override {
    ForEachRow(x, [&](Index row, Index, const LocalJet& jet) { values[row] = jet.value; });
    return true;
  }
  bool eval_jac_g(Index n, const Number* x, bool, Index m, Index count, Index* rows, Index* columns,
                  Number* values) override {
    if (values == nullptr) {
      for (Index i = 0; i < m; ++i)
        for (Index j = 0; j < n; ++j) *rows++ = i, *columns++ = j;
      return true;
    }
    std::fill(values, values + count, 0);
    ForEachRow(x, [&](Index row, Index plane, const LocalJet& jet) {
      for (Index i = 0; i < kLocal; ++i)
        if (i < kPose || plane >= 0) values[row * n + Global(i, plane)] = jet.gradient[i];
    });
    return true;
  }
  bool eval_h(Index n, const Number* x, bool, Number factor, Index, const Number* lambda, bool, Index count,
              Index* rows, Index* columns, Number* values) override {
    if (values == nullptr) {
      for (Index i = 0; i < n; ++i)
        for (Index j = 0; j <= i; ++j) *rows++ = i, *columns++ = j;
      return true;
    }
    std::fill(values, values + count, 0);
    const auto add = [&](Index plane, double times, const LocalJet& jet) {
      for (Index i = 0; i < kLocal; ++i) {
        if (i >= kPose && plane < 0) break;
        const Index row = Global(i, plane);
        for (Index j = 0; j <= i; ++j)
          values[row * (row + 1) / 2 + Global(j, plane)] += times * jet.hessian(i, j);
      }
    };
    add(-1, factor, Objective(x));
    ForEachRow(x, [&](Index row, Index plane, const LocalJet& jet) {
      if (lambda[row] != 0) add(plane, lambda[row], jet);
    });
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number*, const Number*, Index,
                         const Number*, const Number*, Number, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities* quantities) override {
    x_ = Eigen::Map<const VectorXd>(x, n);
    if (quantities == nullptr) return;
    infeasibility = quantities->curr_nlp_constraint_violation(Ipopt::NORM_MAX);
    stationarity = quantities->curr_dual_infeasibility(Ipopt::NORM_MAX);
  }

 private:
  struct Pair {
    std::vector<Vector3d> moving, fixed;
  };

  static Index Global(Index local, Index plane) { return local < kPose ? local : local + plane * kPlane; }
  Feature Scaled(Feature feature) const {
    feature.moving_point /= size_;
    feature.fixed_point /= size_;
    return feature;
  }
  void AddPair(const ConvexPiece& a, const ConvexPiece& b, const Transform& start) {
    if (BallGap(a, b, start) > kNear * size_) return;
    const Separation widest = Widest(a, b, start);
    if (widest.gap > kNear * size_) return;
    Vector3d n;
    if (widest.kind == FeatureKind::kVertexFace)
      n = b.faces[widest.first].normal;
    else if (widest.kind == FeatureKind::kFaceVertex)
      n = -(start.R * a.faces[widest.first].normal);
    else
      n = widest.sign *
          (start.R * a.directions[widest.first]).cross(b.directions[widest.second]).normalized();
    Pair pair;
    double highest = -HUGE_VAL;
    for (const Vector3d& v : a.vertices) pair.moving.push_back(v / size_);
    for (const Vector3d& v : b.vertices)
      pair.fixed.push_back(v / size_), highest = std::max(highest, n.dot(v / size_));
    pairs_.push_back(std::move(pair));
    x_.conservativeResize(x_.size() + kPlane);
    x_.tail<kPlane>() << n, highest + widest.gap / size_ / 2;
  }
  Index Rows() const {
    size_t rows = 1 + features_.size() + pairs_.size();
    for (const Pair& pair : pairs_) rows += pair.moving.size() + pair.fixed.size();
    return static_cast<Index>(rows);
  }
  Posed<LocalJet> PoseJet(const Number* x) const {
    const LocalJet w = LocalJet::Variable(x[0], 0), a = LocalJet::Variable(x[1], 1),
                   b = LocalJet::Variable(x[2], 2), c = LocalJet::Variable(x[3], 3);
    const LocalJet ww = Square(w), aa = Square(a), bb = Square(b), cc = Square(c), ab = a * b * 2,
                   ac = a * c * 2, bc = b * c * 2, wa = w * a * 2, wb = w * b * 2, wc = w * c * 2;
    Posed<LocalJet> posed;
    posed.columns = {Triple<LocalJet>{ww + aa - bb - cc, ab + wc, ac - wb},
                     Triple<LocalJet>{ab - wc, ww - aa + bb - cc, bc + wa},
                     Triple<LocalJet>{ac + wb, bc - wa, ww - aa - bb + cc}};
    posed.at = {LocalJet::Variable(x[4], 4), LocalJet::Variable(x[5], 5), LocalJet::Variable(x[6], 6)};
    posed.reference = reference_;
    return posed;
  }
  LocalJet Objective(const Number* x) const {
    // The quaternion times the seen one's conjugate.
    const auto row = [&](double w, double a, double b, double c) {
      LocalJet jet(w * x[0] + a * x[1] + b * x[2] + c * x[3]);
      jet.gradient.head<4>() << w, a, b, c;
      return jet;
    };
    const double w = seen_.w(), a = seen_.x(), b = seen_.y(), c = seen_.z();
    const LocalJet s = row(w, a, b, c);
    const LocalJet squares =
        Square(row(-a, w, -c, b)) + Square(row(-b, c, w, -a)) + Square(row(-c, -b, a, w));
    const LocalJet cosine = Square(s);
    const double q = cosine.value;
    LocalJet sum =
        SquaredTurn(squares * Chain(cosine, 1 / q, -1 / (q * q), 2 / (q * q * q))) * (length_ * length_);
    for (int i = 0; i < 3; ++i) sum = sum + Square(LocalJet::Variable(x[4 + i], 4 + i) - seen_at_[i]);
    return sum;
  }
  // visit(row, plane, jet); the planes' own variables are the jet's last four.
  template <class Visit>
  void ForEachRow(const Number* x, const Visit& visit) const {
    Index row = 0;
    LocalJet one(-1);
    for (int i = 0; i < 4; ++i) one = one + Square(LocalJet::Variable(x[i], i));
    visit(row++, -1, one);
    const Posed<LocalJet> posed = PoseJet(x);
    for (size_t i = 0; i < equalities_; ++i) visit(row++, -1, ValueOf(features_[i], posed));
    const auto plane_at = [&](size_t k) {
      const Number* own = x + kPose + kPlane * k;
      std::array<LocalJet, 4> plane;
      for (int i = 0; i < 4; ++i) plane[static_cast<size_t>(i)] = LocalJet::Variable(own[i], kPose + i);
      return plane;
    };
    for (size_t k = 0; k < pairs_.size(); ++k) {
      const auto plane = plane_at(k);
      visit(row++, static_cast<Index>(k), Square(plane[0]) + Square(plane[1]) + Square(plane[2]) - 1.0);
    }
    for (size_t i = equalities_; i < features_.size(); ++i) visit(row++, -1, ValueOf(features_[i], posed));
    for (size_t k = 0; k < pairs_.size(); ++k) {
      const auto plane = plane_at(k);
      const Triple<LocalJet> normal{plane[0], plane[1], plane[2]};
      for (const Vector3d& v : pairs_[k].moving)
        visit(row++, static_cast<Index>(k), Dot(posed.Point(v), normal) - plane[3]);
      for (const Vector3d& v : pairs_[k].fixed)
        visit(row++, static_cast<Index>(k), plane[3] - Dot(normal, v));
    }
  }

  double size_, length_;
  Vector3d reference_;
  Eigen::Quaterniond seen_;
  Vector3d seen_at_;
  std::vector<Feature> features_;
  size_t equalities_ = 0;
  std::vector<Pair> pairs_;
  VectorXd x_;
};

}  // namespace

IpoptAnswer NearestPoseByIpopt(const Models& models, const Relation& relation, const Transform& X0,
                               const Transform& start, const Metric& metric) {
  if (!relation.realisation)
    throw PreconditionError("nearest pose by Ipopt: the relation needs a realisation");
  const Ipopt::SmartPtr<Nlp> nlp = new Nlp(models, relation, X0, start, metric);
  const auto lock = LockIpopt();
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> application = IpoptApplicationFactory();
  application->Options()->SetIntegerValue("print_level", 0);
  application->Options()->SetStringValue("sb", "yes");
  application->Options()->SetNumericValue("tol", 1e-9);
  application->Options()->SetNumericValue("constr_viol_tol", 1e-8);
  application->Options()->SetIntegerValue("max_iter", 500);
  IpoptAnswer answer;
  if (application->Initialize() != Ipopt::Solve_Succeeded) return answer;
  const Ipopt::ApplicationReturnStatus status = application->OptimizeTNLP(nlp);
  answer.optimal = status == Ipopt::Solve_Succeeded;
  answer.X_FM = nlp->Pose();
  answer.outcome = Judge(models, relation.contacts, answer.X_FM);
  answer.distance = DisplacementBetween(X0, answer.X_FM, metric.reference).Distance(metric.LengthFor(models));
  const Ipopt::SmartPtr<Ipopt::SolveStatistics> statistics = application->Statistics();
  if (IsValid(statistics)) answer.iterations = statistics->IterationCount();
  answer.infeasibility = nlp->infeasibility, answer.stationarity = nlp->stationarity;
  return answer;
}

}  // namespace tact::correction
