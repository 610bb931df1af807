#include <algorithm>

#include "algebra/cone/cone.h"
#include "algebra/cone/cone_check.h"
#include "algebra/exact/linear_algebra.h"
#include "algebra/exact/word.h"

namespace tact::algebra {
namespace {

// The generators of the inequalities inserted so far. A vector has n entries, a set of tight rows `words`
// words; each kind lies end to end in one array.
template <typename Scalar>
class DoubleDescription {
 public:
  DoubleDescription(const IntegerMatrix& initial_lines, size_t inequalities)
      : n_(initial_lines.columns), words_((inequalities + 63) / 64), line_count_(initial_lines.rows) {
    for (const Integer& entry : initial_lines.entries) lines_.push_back(FromInteger<Scalar>(entry));
  }

  void Insert(std::span<const Integer> inequality, size_t row) {
    row_.clear();
    for (const Integer& entry : inequality) row_.push_back(FromInteger<Scalar>(entry));
    for (size_t i = 0; i < line_count_; ++i) {
      const Scalar value = Value(&lines_[i * n_]);
      if (value.sign() == 0) continue;
      CutLine(i, value, row);
      return;
    }
    CutRays(row);
  }

  ConeGenerators Finish(size_t inequalities) const {
    IntegerMatrix lines(line_count_, n_);
    for (size_t i = 0; i < line_count_ * n_; ++i) lines.entries[i] = ToInteger(lines_[i]);
    const EchelonBasis lineality = RowSpace(lines);
    std::vector<std::pair<IntegerVector, size_t>> order;
    for (size_t k = 0; k < ray_count_; ++k) {
      IntegerVector ray;
      for (size_t j = 0; j < n_; ++j) ray.push_back(ToInteger(rays_[k * n_ + j]));
      order.emplace_back(ReduceModulo(lineality, ray), k);
    }
    std::sort(order.begin(), order.end());
    ConeGenerators result{{lineality.vectors, IntegerMatrix(0, n_)}, {}};
    for (const auto& [ray, k] : order) {
      result.cone.rays.AppendRow(ray);
      RowSet& tight = result.tight.emplace_back(inequalities);
      for (size_t row = 0; row < inequalities; ++row) {
        if ((tight_[k * words_ + row / 64] >> (row % 64) & 1) != 0) tight.Insert(row);
      }
    }
    return result;
  }

 private:
  Scalar Value(const Scalar* vector) const {
    Scalar sum(0);
    for (size_t j = 0; j < n_; ++j) sum += row_[j] * vector[j];
    return sum;
  }

  // target = a x - b y over its greatest common divisor.
  void Combine(Scalar a, const Scalar* x, Scalar b, const Scalar* y, Scalar* target) const {
    const Scalar common = Gcd(a, b);
    a = DivideExactly(a, common);
    b = DivideExactly(b, common);
    for (size_t j = 0; j < n_; ++j) target[j] = a * x[j] - b * y[j];
    MakePrimitive(target, n_);
  }

  void MarkTight(size_t ray, size_t row) { tight_[ray * words_ + row / 64] |= uint64_t{1} << (row % 64); }

  // Line i leaves the hyperplane of the new row: it becomes a ray, all others are moved along it into the
  // hyperplane.
  void CutLine(size_t i, Scalar value, size_t row) {
    std::swap_ranges(&lines_[i * n_], &lines_[i * n_] + n_, &lines_[(line_count_ - 1) * n_]);
    --line_count_;
    Scalar* const cut = &lines_[line_count_ * n_];
    if (value.sign() < 0) {
      value = -value;
      for (size_t j = 0; j < n_; ++j) cut[j] = -cut[j];
    }
    for (size_t k = 0; k < line_count_; ++k) {
      Scalar* const line = &lines_[k * n_];
      const Scalar other = Value(line);
      if (other.sign() != 0) Combine(value, line, other, cut, line);
    }
    for (size_t k = 0; k < ray_count_; ++k) {
      Scalar* const ray = &rays_[k * n_];
      const Scalar other = Value(ray);
      if (other.sign() != 0) Combine(value, ray, other, cut, ray);
      MarkTight(k, row);
    }
    rays_.insert(rays_.end(), cut, cut + n_);
    tight_.resize(tight_.size() + words_);
    for (size_t earlier = 0; earlier < row; ++earlier) MarkTight(ray_count_, earlier);
    ++ray_count_;
    lines_.resize(line_count_ * n_);
  }

  // Rays below the hyperplane go; each edge from one of them to a ray above meets the hyperplane in a new
  // ray.
  void CutRays(size_t row) {
    values_.clear();
    below_.clear();
    above_.clear();
    for (size_t k = 0; k < ray_count_; ++k) {
      values_.push_back(Value(&rays_[k * n_]));
      const int sign = values_[k].sign();
      if (sign < 0) below_.push_back(k);
      if (sign > 0) above_.push_back(k);
      if (sign == 0) MarkTight(k, row);
    }
    if (below_.empty()) return;
    next_rays_.clear();
    next_tight_.clear();
    for (size_t k = 0; k < ray_count_; ++k) {
      if (values_[k].sign() < 0) continue;
      next_rays_.insert(next_rays_.end(), &rays_[k * n_], &rays_[k * n_] + n_);
      next_tight_.insert(next_tight_.end(), &tight_[k * words_], &tight_[k * words_] + words_);
    }
    for (const size_t plus : above_) {
      for (const size_t minus : below_) {
        if (!Adjacent(plus, minus)) continue;
        const size_t begin = next_rays_.size();
        next_rays_.resize(begin + n_);
        Combine(values_[plus], &rays_[minus * n_], values_[minus], &rays_[plus * n_], &next_rays_[begin]);
        next_tight_.insert(next_tight_.end(), common_.begin(), common_.end());
        next_tight_[next_tight_.size() - words_ + row / 64] |= uint64_t{1} << (row % 64);
      }
    }
    rays_.swap(next_rays_);
    tight_.swap(next_tight_);
    ray_count_ = rays_.size() / n_;
  }

  // Whether no third ray is tight wherever both are; common_ becomes the rows where both are.
  bool Adjacent(size_t a, size_t b) {
    common_.resize(words_);
    size_t count = 0;
    for (size_t w = 0; w < words_; ++w) {
      common_[w] = tight_[a * words_ + w] & tight_[b * words_ + w];
      count += static_cast<size_t>(std::popcount(common_[w]));
    }
    // The rows tight on a two-dimensional face have its codimension as their rank, modulo lines and
    // equalities.
    if (count + line_count_ + 2 < initial_line_count_) return false;
    for (size_t k = 0; k < ray_count_; ++k) {
      if (k == a || k == b) continue;
      size_t w = 0;
      while (w < words_ && (common_[w] & ~tight_[k * words_ + w]) == 0) ++w;
      if (w == words_) return false;
    }
    return true;
  }

  size_t n_;
  size_t words_;
  size_t line_count_;
  size_t initial_line_count_ = line_count_;
  size_t ray_count_ = 0;
  std::vector<Scalar> lines_, rays_, next_rays_, values_, row_;
  std::vector<uint64_t> tight_, next_tight_, common_;
  std::vector<size_t> above_, below_;
};

}  // namespace

ConeGenerators Generators(const HalfspaceCone& cone) {
  RequireRows("inequality", cone.inequalities, cone.ambient_dimension());
  RequireRows("equality", cone.equalities, cone.ambient_dimension());
  const IntegerMatrix initial_lines = cone.equalities.rows == 0
                                          ? IntegerMatrix::Identity(cone.ambient_dimension())
                                          : NullSpace(cone.equalities);
  return WordsFirst([&]<typename Scalar>(const Scalar&) {
    DoubleDescription<Scalar> description(initial_lines, cone.inequalities.rows);
    for (size_t i = 0; i < cone.inequalities.rows; ++i) description.Insert(cone.inequalities.row(i), i);
    return description.Finish(cone.inequalities.rows);
  });
}

std::vector<size_t> ImplicitEqualities(const ConeGenerators& generators, size_t inequalities) {
  RowSet common = RowSet::All(inequalities);
  for (const RowSet& tight : generators.tight) common &= tight;
  return common.ToVector();
}

}  // namespace tact::algebra
