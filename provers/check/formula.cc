#include "provers/check/formula.h"

#include <algorithm>
#include <iterator>

namespace tact::check {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Reader {
 public:
  Reader(const Value& formula, const std::function<Terms(const std::string&)>& variable)
      : where_(&formula), text_(AsString(formula)), variable_(variable) {}

  Terms Read() {
    Terms sum = ReadSum(0);
    if (Peek() != '\0') Refuse("expected an operator");
    return sum;
  }

 private:
  [[noreturn]] void Refuse(const std::string& why) const {
    throw Refused(where_, why + " at character " + std::to_string(at_ + 1));
  }
  char Peek() {
    while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool Take(char c) {
    if (Peek() != c) return false;
    ++at_;
    return true;
  }
  std::string Run(bool letters) {
    const std::size_t start = at_;
    while (at_ < text_.size() && (IsDigit(text_[at_]) || (letters && IsLetter(text_[at_])))) ++at_;
    return text_.substr(start, at_ - start);
  }

  Terms ReadSum(std::size_t depth) {
    if (depth > kMaxFormulaDepth) Refuse("nested too deep");
    Terms sum = ReadProduct(depth);
    while (true) {
      if (Take('+')) {
        sum = sum + ReadProduct(depth);
      } else if (Take('-')) {
        sum = sum - ReadProduct(depth);
      } else {
        return sum;
      }
    }
  }
  Terms ReadProduct(std::size_t depth) {
    Terms product = ReadPower(depth);
    while (Take('*')) product = Multiply(product, ReadPower(depth), where_);
    return product;
  }
  Terms ReadPower(std::size_t depth) {
    if (depth > kMaxFormulaDepth) Refuse("nested too deep");
    if (Take('-')) return Terms() - ReadPower(depth + 1);
    const Terms base = ReadAtom(depth);
    if (!Take('^')) return base;
    Peek();
    const std::string digits = Run(false);
    if (digits.empty() || digits.size() > 2) Refuse("expected an exponent of one or two digits");
    const auto exponent = static_cast<unsigned>(std::stoul(digits));
    if (exponent > kMaxPower) Refuse("the exponent is beyond " + std::to_string(kMaxPower));
    Terms power = {{{}, 1}};
    for (unsigned i = 0; i < exponent; ++i) power = Multiply(power, base, where_);
    return power;
  }
  Terms ReadAtom(std::size_t depth) {
    if (Take('(')) {
      Terms sum = ReadSum(depth + 1);
      if (!Take(')')) Refuse("expected )");
      return sum;
    }
    const char next = Peek();
    if (IsLetter(next)) return variable_(Run(true));
    if (!IsDigit(next)) Refuse("expected a number, a name or (");
    const std::string digits = Run(false);
    if (digits.size() > kMaxDigits) Refuse("a number of too many digits");
    const mpz_class number(digits, 10);
    return number == 0 ? Terms() : Terms{{{}, number}};
  }

  const Value* where_;
  const std::string& text_;
  const std::function<Terms(const std::string&)>& variable_;
  std::size_t at_ = 0;
};

void AddTo(Terms& sum, const std::vector<std::string>& variables, const mpz_class& coefficient) {
  const auto place = sum.try_emplace(variables, 0).first;
  place->second += coefficient;
  if (place->second == 0) sum.erase(place);
}

}  // namespace

Terms operator+(const Terms& a, const Terms& b) {
  Terms sum = a;
  for (const auto& [variables, coefficient] : b) AddTo(sum, variables, coefficient);
  return sum;
}

Terms operator-(const Terms& a, const Terms& b) {
  Terms difference = a;
  for (const auto& [variables, coefficient] : b) AddTo(difference, variables, -coefficient);
  return difference;
}

Terms Multiply(const Terms& a, const Terms& b, const Value* where) {
  if (!b.empty() && a.size() > kMaxTerms / b.size()) throw Refused(where, "too many terms");
  Terms product;
  for (const auto& [in_a, coefficient_a] : a) {
    for (const auto& [in_b, coefficient_b] : b) {
      std::vector<std::string> variables;
      std::merge(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), std::back_inserter(variables));
      AddTo(product, variables, coefficient_a * coefficient_b);
    }
  }
  return product;
}

Terms Expand(const Value& formula, const std::function<Terms(const std::string& name)>& variable) {
  return Reader(formula, variable).Read();
}

}  // namespace tact::check
