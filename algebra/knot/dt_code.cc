#include "algebra/knot/dt_code.h"

#include "algebra/error.h"

namespace tact::knot {

std::vector<int> DtCodeOf(const ClosedCode& closed) {
  const PData& p = closed.cut;
  std::vector<int> code;
  for (int i = 1; i <= p.columns(); i += 2) {
    const int even = p.sigma(i);
    if (even % 2 != 0)
      throw PreconditionError("DtCodeOf: expected a diagram on a sphere, got two odd passes");
    code.push_back(p.over(even) ? -even : even);
  }
  return code;
}

std::string DtText(const std::vector<int>& code) {
  std::string text;
  for (const int even : code) text += (text.empty() ? "" : " ") + std::to_string(even);
  return text.empty() ? "/" : text;
}

}  // namespace tact::knot
