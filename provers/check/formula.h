/// @file
/// Formulas of integers and named variables, and the polynomials they are.
/// Model   sum = product { ("+" | "-") product }; product = power { "*" power }; power = "-" power | atom [ "^" digits ];
///         atom = digits | name | "(" sum ")"; a name is letters and digits, a letter first. Blanks separate.
/// Exact   + * = only.
/// Errors  Refused: no such formula, or beyond a limit below.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "provers/check/json_value.h"

namespace tact::check {

inline constexpr std::size_t kMaxFormulaDepth = 100;
inline constexpr unsigned kMaxPower = 16;
inline constexpr std::size_t kMaxTerms = 100000;

/// The coefficient of each product of variables, named in order with repetition; no coefficient is zero.
using Terms = std::map<std::vector<std::string>, mpz_class>;

Terms operator+(const Terms& a, const Terms& b);
Terms operator-(const Terms& a, const Terms& b);
/// Refused, with `where`: more than kMaxTerms products to add.
Terms Multiply(const Terms& a, const Terms& b, const Value* where);

/// The polynomial that the formula in the JSON string is, after each variable is replaced by what `variable` says.
Terms Expand(const Value& formula, const std::function<Terms(const std::string& name)>& variable);

}  // namespace tact::check
