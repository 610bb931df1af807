#include "algebra/knot/turns.h"

#include <algorithm>

#include "algebra/knot/faces.h"

namespace tact::knot {
namespace {

size_t Index(int column) { return static_cast<size_t>(column); }

bool Interlace(const PData& p, int i, int a) {
  const auto [first, second] = std::minmax(i, a);
  return first < second && second < p.sigma(first) && p.sigma(first) < p.sigma(second);
}

}  // namespace

bool TurnsAgree(const PData& p, int i, int a) {
  const auto gap = [&](int column) {
    if (column <= i || column >= p.sigma(a) || column == a || column == p.sigma(i)) return 0;
    return column < a ? 1 : column < p.sigma(i) ? 2 : 3;
  };
  bool odd = false;
  for (int z = i + 1; z < p.sigma(a); ++z) {
    const int one = gap(z), other = gap(p.sigma(z));
    if (z < p.sigma(z) && one != 0 && other != 0 && one != other) odd = !odd;
  }
  return odd;
}

std::optional<PData> WithPlanarTurns(const PData& p) {
  std::vector<int> turns(Index(p.columns()) + 1, 0);  // of first columns; 0: not known yet
  for (int first = 1; first <= p.columns(); ++first) {
    if (p.sigma(first) < first || turns[Index(first)] != 0) continue;
    turns[Index(first)] = 1;
    std::vector<int> waiting = {first};
    while (!waiting.empty()) {
      const int i = waiting.back();
      waiting.pop_back();
      for (int a = 1; a <= p.columns(); ++a) {
        if (p.sigma(a) < a || turns[Index(a)] != 0 || !Interlace(p, i, a)) continue;
        turns[Index(a)] = turns[Index(i)] * (TurnsAgree(p, std::min(i, a), std::max(i, a)) ? 1 : -1);
        waiting.push_back(a);
      }
    }
  }
  PDataBuilder turned(p.columns());
  for (int i = 1; i <= p.columns(); ++i) {
    const int turn = p.sigma(i) > i ? turns[Index(i)] : -turns[Index(p.sigma(i))];
    turned.Add(p.sigma(i), AttributeOf(p.over(i), turn));
  }
  const PData planar = turned.Take();
  if (!IsPlanar(planar)) return std::nullopt;
  return planar;
}

}  // namespace tact::knot
