/// @file
/// Formulas of integers and named variables, and the polynomials they are.
/// Model   sum = product { ("+" | "-") product }; product = power { "*" power }; power = "-" power | atom [ "^" digits
///         ]; atom = digits | name | "(" sum ")"; a name is letters and digits, a letter first. Blanks separate.
/// Exact   + * = only.
/// Errors  Refused: no such formula, or beyond a limit below.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "provers/check/json_value.h"

namespace tact::check {

inline constexpr std::size_t kMaxFormulaDepth = 100;
inline constexpr unsigned kMaxPower = 16;
inline constexpr std::size_t kMaxProducts = 200000;  // of two terms, in all formulas of a certificate

inline constexpr std::size_t kMaxDegree = 200;
inline constexpr std::size_t kMaxBits = 400000;  // of a coefficient

/// The coefficient of each product of variables, named in order with repetition; no coefficient is zero.
using Terms = std::map<std::vector<std::string>, mpz_class>;

/// a += factor * b.
void Add(Terms& a, const Terms& b, int factor);

/// Expands formulas, and counts what that costs.
class Expander {
 public:
  /// What each variable is replaced by.
  explicit Expander(std::function<Terms(const std::string& name)> variable)
      : variable_(std::move(variable)) {}

  /// The polynomial that the formula in the JSON string is.
  Terms Expand(const Value& formula);
  /// Refused, with `where`: beyond a limit above.
  Terms Multiply(const Terms& a, const Terms& b, const Value* where);
  Terms Replace(const std::string& name) const { return variable_(name); }

 private:
  std::function<Terms(const std::string& name)> variable_;
  std::size_t products_ = 0;
};

}  // namespace tact::check
