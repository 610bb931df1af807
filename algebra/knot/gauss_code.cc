#include "algebra/knot/gauss_code.h"

#include <cstdlib>

#include "algebra/error.h"

namespace tact::knot {

std::optional<GaussFault> FindGaussFault(const GaussCode& code) {
  const int crossings = static_cast<int>(code.signs.size());
  if (code.passes.size() != 2 * code.signs.size()) {
    return GaussFault{0, "expected two passes for each intersection's sign, got " +
                             std::to_string(code.passes.size()) + " passes and " + std::to_string(crossings) +
                             (crossings == 1 ? " sign" : " signs")};
  }
  for (const int sign : code.signs) {
    if (sign != 1 && sign != -1)
      return GaussFault{0, "expected signs +1 and -1, got " + std::to_string(sign)};
  }
  std::vector<bool> over(code.signs.size()), under(code.signs.size());
  for (size_t pass = 0; pass < code.passes.size(); ++pass) {
    const int number = code.passes[pass], place = static_cast<int>(pass) + 1;
    if (number == 0 || number < -crossings || number > crossings) {
      return GaussFault{place, "expected an intersection from 1 to " + std::to_string(crossings) + ", got " +
                                   std::to_string(number < 0 ? -number : number)};
    }
    std::vector<bool>& met = number > 0 ? over : under;
    const size_t index = static_cast<size_t>(std::abs(number)) - 1;
    if (met[index]) {
      return GaussFault{place, "expected intersection " + std::to_string(std::abs(number)) +
                                   " once over and once under, got it twice " +
                                   (number > 0 ? "over" : "under")};
    }
    met[index] = true;
  }
  return std::nullopt;
}

GaussCode GaussCodeOf(const PData& p) {
  GaussCode code;
  std::vector<int> numbers(static_cast<size_t>(p.columns()) + 1, 0);
  for (int i = 1; i <= p.columns(); ++i) {
    int& number = numbers[static_cast<size_t>(i)];
    if (p.sigma(i) > i) {
      code.signs.push_back(p.sign(i));
      number = static_cast<int>(code.signs.size());
    } else {
      number = numbers[static_cast<size_t>(p.sigma(i))];
    }
    code.passes.push_back(p.over(i) ? number : -number);
  }
  return code;
}

PData PDataOf(const GaussCode& code) {
  if (const auto fault = FindGaussFault(code)) throw PreconditionError("Gauss code: " + fault->what);
  const auto index = [](int number) { return static_cast<size_t>(std::abs(number)) - 1; };
  std::vector<int> sum(code.signs.size(), 0);  // of both columns of an intersection
  for (size_t i = 0; i < code.passes.size(); ++i) sum[index(code.passes[i])] += static_cast<int>(i) + 1;
  PDataBuilder p(static_cast<int>(code.passes.size()));
  for (size_t i = 0; i < code.passes.size(); ++i) {
    const int pass = code.passes[i];
    p.Add(sum[index(pass)] - static_cast<int>(i) - 1,
          (pass > 0 ? 1 : 2) + (code.signs[index(pass)] > 0 ? 2 : 0));
  }
  return p.Take();
}

std::string ToText(const GaussCode& code) {
  std::string text;
  for (const int pass : code.passes) {
    const int number = std::abs(pass);
    if (!text.empty()) text += ' ';
    text += (pass > 0 ? 'O' : 'U') + std::to_string(number);
    text += code.signs[static_cast<size_t>(number) - 1] > 0 ? '+' : '-';
  }
  return text.empty() ? "/" : text;
}

std::string ToExtendedText(const GaussCode& code) {
  std::string text;
  for (const int pass : code.passes) text += std::to_string(pass) + ' ';
  for (const int sign : code.signs) text += sign > 0 ? '+' : '-';
  return text.empty() ? "/" : text;
}

}  // namespace tact::knot
