#include "provers/check/formula.h"

#include <algorithm>
#include <iterator>

namespace tact::check {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

class Reader {
 public:
  Reader(const Value& formula, Expander& expander)
      : where_(&formula), text_(AsString(formula)), expander_(expander) {}

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
        Add(sum, ReadProduct(depth), 1);
      } else if (Take('-')) {
        Add(sum, ReadProduct(depth), -1);
      } else {
        return sum;
      }
    }
  }
  Terms ReadProduct(std::size_t depth) {
    Terms product = ReadPower(depth);
    while (Take('*')) product = expander_.Multiply(product, ReadPower(depth), where_);
    return product;
  }
  Terms ReadPower(std::size_t depth) {
    if (depth > kMaxFormulaDepth) Refuse("nested too deep");
    if (Take('-')) {
      Terms negative;
      Add(negative, ReadPower(depth + 1), -1);
      return negative;
    }
    const Terms base = ReadAtom(depth);
    if (!Take('^')) return base;
    Peek();
    const std::string digits = Run(false);
    if (digits.empty() || digits.size() > 2) Refuse("expected an exponent of one or two digits");
    const auto exponent = static_cast<unsigned>(std::stoul(digits));
    if (exponent > kMaxPower) Refuse("the exponent is beyond " + std::to_string(kMaxPower));
    Terms power = {{{}, 1}};
    for (unsigned i = 0; i < exponent; ++i) power = expander_.Multiply(power, base, where_);
    return power;
  }
  Terms ReadAtom(std::size_t depth) {
    if (Take('(')) {
      Terms sum = ReadSum(depth + 1);
      if (!Take(')')) Refuse("expected )");
      return sum;
    }
    const char next = Peek();
    if (IsLetter(next)) return expander_.Replace(Run(true));
    if (!IsDigit(next)) Refuse("expected a number, a name or (");
    const std::string digits = Run(false);
    if (digits.size() > kMaxDigits) Refuse("a number of too many digits");
    const mpz_class number(digits, 10);
    return number == 0 ? Terms() : Terms{{{}, number}};
  }

  const Value* where_;
  const std::string& text_;
  Expander& expander_;
  std::size_t at_ = 0;
};

std::size_t Bits(const mpz_class& number) { return mpz_sizeinbase(number.get_mpz_t(), 2); }

void AddTo(Terms& sum, const std::vector<std::string>& variables, const mpz_class& coefficient) {
  const auto place = sum.try_emplace(variables, 0).first;
  place->second += coefficient;
  if (place->second == 0) sum.erase(place);
}

}  // namespace

void Add(Terms& a, const Terms& b, int factor) {
  for (const auto& [variables, coefficient] : b) AddTo(a, variables, factor * coefficient);
}

Terms Expander::Expand(const Value& formula) { return Reader(formula, *this).Read(); }

Terms Expander::Multiply(const Terms& a, const Terms& b, const Value* where) {
  if (!b.empty() && a.size() > (kMaxProducts - products_) / b.size()) throw Refused(where, "too many terms");
  products_ += a.size() * b.size();
  Terms product;
  for (const auto& [in_a, coefficient_a] : a) {
    for (const auto& [in_b, coefficient_b] : b) {
      if (in_a.size() + in_b.size() > kMaxDegree || Bits(coefficient_a) + Bits(coefficient_b) > kMaxBits)
        throw Refused(where, "too high a degree or too large a number");
      std::vector<std::string> variables;
      std::merge(in_a.begin(), in_a.end(), in_b.begin(), in_b.end(), std::back_inserter(variables));
      AddTo(product, variables, coefficient_a * coefficient_b);
    }
  }
  return product;
}

}  // namespace tact::check
