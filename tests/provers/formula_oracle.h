/// @file
/// Whether identities of formulas hold, by their values at a few large random points: a polynomial of degree d that is
/// not zero is zero at no more than d of 2^60 values of each variable (Schwartz 1980). Part of certificate_oracle.h.
#pragma once

#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "algebra/exact/integer.h"

namespace tact::provers::oracle {

using Values = std::map<std::string, algebra::Integer>;

/// The value of a formula; empty where docs/certificates.md calls the text none.
class FormulaValue {
 public:
  using Integer = algebra::Integer;
  using Value = std::optional<Integer>;

  /// Variables without a value draw one from `random`, where that is given; otherwise there is no value.
  static Value Of(const std::string& formula, Values& values, std::mt19937_64* random) {
    FormulaValue reader{formula, values, random};
    const Value sum = reader.Sum();
    return reader.Next() == '\0' ? sum : std::nullopt;
  }

 private:
  FormulaValue(const std::string& formula, Values& values, std::mt19937_64* random)
      : text_(formula), values_(values), random_(random) {}

  char Next() {
    while (text_[at_] == ' ') ++at_;  // the end is '\0'
    return text_[at_];
  }
  std::string While(int (*is)(int)) {
    std::string run;
    for (Next(); is(static_cast<unsigned char>(text_[at_])) != 0; ++at_) run += text_[at_];
    return run;
  }
  Value Sum() {
    Value sum = Product();
    while (sum && (Next() == '+' || Next() == '-')) {
      const bool plus = text_[at_++] == '+';
      const Value term = Product();
      sum = term ? Value(plus ? *sum + *term : *sum - *term) : std::nullopt;
    }
    return sum;
  }
  Value Product() {
    Value product = Power();
    while (product && Next() == '*') {
      ++at_;
      const Value factor = Power();
      product = factor ? Value(*product * *factor) : std::nullopt;
    }
    return product;
  }
  Value Power() {
    if (Next() == '-') {
      ++at_;
      const Value power = Power();
      return power ? Value(-*power) : std::nullopt;
    }
    const Value base = Atom();
    if (!base || Next() != '^') return base;
    ++at_;
    const std::string digits = While(std::isdigit);
    if (digits.empty() || digits.size() > 2 || std::stoi(digits) > 16) return std::nullopt;
    Integer power(1);
    for (int i = 0; i < std::stoi(digits); ++i) power = power * *base;
    return power;
  }
  Value Atom() {
    if (Next() == '(') {
      ++at_;
      const Value sum = Sum();
      if (Next() != ')') return std::nullopt;
      ++at_;
      return sum;
    }
    if (std::isdigit(static_cast<unsigned char>(Next())) != 0)
      return Integer::Parse(While(std::isdigit)).value();
    const std::string name = std::isalpha(static_cast<unsigned char>(Next())) != 0 ? While(std::isalnum) : "";
    if (name.empty()) return std::nullopt;
    if (!values_.contains(name)) {
      if (random_ == nullptr) return std::nullopt;
      values_[name] = Integer(static_cast<long long>((*random_)() >> 4));
    }
    return values_[name];
  }

  std::string text_;
  Values& values_;
  std::mt19937_64* random_;
  size_t at_ = 0;
};

inline bool IdentityIsRight(const nlohmann::json& c) {
  std::mt19937_64 random(1980);
  for (int point = 0; point < 2; ++point) {
    Values values;
    const auto value = [&](const nlohmann::json& formula) {
      return FormulaValue::Of(formula.get<std::string>(), values, &random);
    };
    std::vector<FormulaValue::Value> given;
    for (const auto& zero : c["given"]) given.push_back(value(zero));
    for (const auto& equation : c["equations"]) {
      const auto left = value(equation["left"]), right = value(equation["right"]);
      if (!left || !right || equation["cofactors"].size() != given.size()) return false;
      algebra::Integer sum = *right;
      for (size_t i = 0; i < given.size(); ++i) {
        const auto cofactor = value(equation["cofactors"][i]);
        if (!given[i] || !cofactor) return false;
        sum += *cofactor * *given[i];
      }
      if (sum != *left) return false;
    }
  }
  return !c["equations"].empty();
}

inline bool NoIdentityIsRight(const nlohmann::json& c) {
  Values values;
  for (const auto& [name, value] : c["values"].items())
    values[name] = algebra::Integer(value.get<long long>());
  const auto value = [&](const nlohmann::json& formula) {
    return FormulaValue::Of(formula.get<std::string>(), values, nullptr);
  };
  for (const auto& zero : c["given"]) {
    const auto number = value(zero);
    if (!number || number->sign() != 0) return false;
  }
  const auto left = value(c["left"]), right = value(c["right"]);
  return left && right && *left != *right;
}

}  // namespace tact::provers::oracle
