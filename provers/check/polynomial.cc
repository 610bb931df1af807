#include "provers/check/polynomial.h"

#include <algorithm>
#include <cstddef>

namespace tact::check {
namespace {

constexpr int kHalvings = 24;

template <typename Combine>
Polynomial Termwise(const Polynomial& a, const Polynomial& b, Combine combine) {
  std::vector<mpz_class> sum(std::max(a.coefficients().size(), b.coefficients().size()));
  for (std::size_t i = 0; i < a.coefficients().size(); ++i) sum[i] = a.coefficients()[i];
  for (std::size_t i = 0; i < b.coefficients().size(); ++i) combine(sum[i], b.coefficients()[i]);
  return Polynomial(std::move(sum));
}

// n! times the Bernstein coefficients, n one less than the number of coefficients:
// b_i = sum over k of binomial(i, k) / binomial(n, k) c_k.
std::vector<mpz_class> Bernstein(const std::vector<mpz_class>& c) {
  const std::size_t n = c.size() - 1;
  std::vector<mpz_class> b(c.size());
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      mpz_class choices, k_factorial, rest_factorial;
      mpz_bin_uiui(choices.get_mpz_t(), i, k);
      mpz_fac_ui(k_factorial.get_mpz_t(), k);
      mpz_fac_ui(rest_factorial.get_mpz_t(), n - k);
      b[i] += choices * k_factorial * rest_factorial * c[k];
    }
  }
  return b;
}

// Positive on [0, 1), from (a positive multiple of) the Bernstein coefficients.
bool IsPositive(const std::vector<mpz_class>& b, int halvings) {
  if (b.front() <= 0 || b.back() < 0) return false;
  if (std::all_of(b.begin(), b.end(), [](const mpz_class& x) { return x >= 0; })) return true;
  if (halvings == 0) return false;
  // De Casteljau, times 2^n.
  const std::size_t n = b.size() - 1;
  std::vector<mpz_class> left(n + 1), right(n + 1), row = b;
  for (std::size_t j = 0; j <= n; ++j) {
    const mpz_class scale = mpz_class(1) << (n - j);
    left[j] = row.front() * scale;
    right[n - j] = row.back() * scale;
    for (std::size_t i = 0; i + 1 < row.size(); ++i) row[i] += row[i + 1];
    row.pop_back();
  }
  return IsPositive(left, halvings - 1) && IsPositive(right, halvings - 1);
}

}  // namespace

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  return Termwise(a, b, [](mpz_class& x, const mpz_class& y) { x += y; });
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  return Termwise(a, b, [](mpz_class& x, const mpz_class& y) { x -= y; });
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  if (a.coefficients_.empty() || b.coefficients_.empty()) return {};
  std::vector<mpz_class> product(a.coefficients_.size() + b.coefficients_.size() - 1);
  for (std::size_t i = 0; i < a.coefficients_.size(); ++i) {
    for (std::size_t j = 0; j < b.coefficients_.size(); ++j)
      product[i + j] += a.coefficients_[i] * b.coefficients_[j];
  }
  return Polynomial(std::move(product));
}

std::optional<int> SignOn(const Polynomial& polynomial) {
  std::vector<mpz_class> c = polynomial.coefficients();
  while (!c.empty() && c.back() == 0) c.pop_back();
  if (c.empty()) return 0;
  if (c.front() == 0) return std::nullopt;
  const int sign = c.front() > 0 ? 1 : -1;
  std::vector<mpz_class> b = Bernstein(c);
  for (mpz_class& x : b) x = x * sign;
  if (!IsPositive(b, kHalvings)) return std::nullopt;
  return sign;
}

PolynomialVector Cross(const PolynomialVector& a, const PolynomialVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Polynomial Dot(const PolynomialVector& a, const PolynomialVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

PolynomialVector Constant(const Row& v) { return {v[0], v[1], v[2]}; }

}  // namespace tact::check
