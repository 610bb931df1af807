#include "algebra/knot/columns.h"

#include <algorithm>

namespace tact::knot {

PData InsertColumns(const PData& p, const Renumbering& to, std::initializer_list<NewColumn> added) {
  PDataBuilder grown(p.columns() + static_cast<int>(added.size()));
  const NewColumn* next = added.begin();
  const auto fill = [&](int until) {
    for (; next != added.end() && next->column < until; ++next) grown.Add(next->sigma, next->attr);
  };
  for (int i = 1; i <= p.columns(); ++i) {
    fill(to(i));
    grown.Add(to(p.sigma(i)), p.attr(i));
  }
  fill(std::numeric_limits<int>::max());
  return grown.Take();
}

PData RemoveColumns(const PData& p, std::initializer_list<int> removed) {
  const auto below = [&](int column) {
    return static_cast<int>(std::lower_bound(removed.begin(), removed.end(), column) - removed.begin());
  };
  PDataBuilder rest(p.columns());
  const int* next = removed.begin();
  for (int i = 1; i <= p.columns(); ++i) {
    if (next != removed.end() && *next == i) {
      ++next;
      continue;
    }
    rest.Add(p.sigma(i) - below(p.sigma(i)), p.attr(i));
  }
  return rest.Take();
}

}  // namespace tact::knot
