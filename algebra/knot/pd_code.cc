#include "algebra/knot/pd_code.h"

#include <algorithm>

#include "algebra/error.h"

namespace tact::knot {
namespace {

std::string TextOf(const std::array<int, 4>& arcs) {
  std::string text;
  for (const int arc : arcs) text += (text.empty() ? "X[" : ",") + std::to_string(arc);
  return text + "]";
}

// Arc that enters a column, arc that leaves it.
template <typename Enter, typename Leave>
PdCode CodeOf(const PData& p, const Enter& enter, const Leave& leave) {
  PdCode code;
  for (int i = 1; i <= p.columns(); ++i) {
    if (p.sigma(i) < i) continue;
    const int under = p.over(i) ? p.sigma(i) : i, over = p.sigma(under);
    const bool plus = p.sign(i) > 0;
    code.crossings.push_back(
        {enter(under), plus ? leave(over) : enter(over), leave(under), plus ? enter(over) : leave(over)});
  }
  return code;
}

bool IsClosed(const PdCode& code) {
  std::vector<int> arcs;
  for (const auto& crossing : code.crossings) arcs.insert(arcs.end(), crossing.begin(), crossing.end());
  std::sort(arcs.begin(), arcs.end());
  for (size_t i = 0; i < arcs.size(); i += 2) {
    if (arcs[i] != arcs[i + 1]) return false;
  }
  return !arcs.empty();
}

}  // namespace

std::optional<PdFault> FindPdFault(const PdCode& code) {
  if (IsClosed(code)) {
    return PdFault{0, "expected an open rope, whose first and last arc come once, got a closed knot's code"};
  }
  const int n = 2 * static_cast<int>(code.crossings.size());
  std::vector<bool> entered(static_cast<size_t>(n), false);
  for (size_t index = 0; index < code.crossings.size(); ++index) {
    const std::array<int, 4>& arcs = code.crossings[index];
    const auto fault = [&](const std::string& expected) {
      return PdFault{static_cast<int>(index) + 1, "expected " + expected + ", got " + TextOf(arcs)};
    };
    const auto [i, j, k, l] = arcs;
    for (const int arc : arcs) {
      if (arc < 0 || arc > n) return fault("arcs from 0 to " + std::to_string(n));
    }
    if (k != i + 1) return fault("the lower strand to go on with arc " + std::to_string(i + 1));
    if (l != j + 1 && j != l + 1) return fault("the upper strand to go on with the next arc");
    for (const int arc : {i, std::min(j, l)}) {
      if (entered[static_cast<size_t>(arc)])
        return fault("arc " + std::to_string(arc) + " to end at one intersection");
      entered[static_cast<size_t>(arc)] = true;
    }
  }
  return std::nullopt;
}

PdCode PdCodeOf(const PData& p) {
  return CodeOf(
      p, [](int column) { return column - 1; }, [](int column) { return column; });
}

PdCode ClosedPdCodeOf(const PData& p) {
  return CodeOf(
      p, [](int column) { return column; }, [&](int column) { return column % p.columns() + 1; });
}

PData PDataOf(const PdCode& code) {
  if (const auto fault = FindPdFault(code)) throw PreconditionError("PD code: " + fault->what);
  std::vector<int> sigma(2 * code.crossings.size()), attr(sigma.size());
  for (const auto& [i, j, k, l] : code.crossings) {
    const int over = std::min(j, l), sign = j > l ? 2 : 0;  // 0-based columns are the arcs that enter
    sigma[static_cast<size_t>(i)] = over + 1;
    sigma[static_cast<size_t>(over)] = k;
    attr[static_cast<size_t>(i)] = 2 + sign;
    attr[static_cast<size_t>(over)] = 1 + sign;
  }
  return PData(sigma, attr);
}

std::string ToText(const PdCode& code) {
  std::string text;
  for (const auto& arcs : code.crossings) text += (text.empty() ? "" : ",") + TextOf(arcs);
  return "PD[" + text + "]";
}

}  // namespace tact::knot
