#include "algebra/solid/box_sweep.h"

#include <algorithm>
#include <tuple>

namespace tact::algebra {
namespace {

int LongestAxis(const std::vector<BoundingBox>& boxes) {
  BoundingBox all;
  for (const BoundingBox& box : boxes) all.Add(box);
  int longest = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (all.high[axis] - all.low[axis] > all.high[longest] - all.low[longest]) longest = axis;
  }
  return longest;
}

struct Start {
  double low;
  bool is_left;
  size_t index;
  auto Key() const { return std::tuple(low, is_left, index); }
};

}  // namespace

void SweepOverlaps(const std::vector<BoundingBox>& lefts, const std::vector<BoundingBox>& rights,
                   const std::function<bool(size_t, size_t)>& visit) {
  const int axis = LongestAxis(rights);
  std::vector<Start> starts;
  starts.reserve(lefts.size() + rights.size());
  for (size_t i = 0; i < lefts.size(); ++i) starts.push_back({lefts[i].low[axis], true, i});
  for (size_t j = 0; j < rights.size(); ++j) starts.push_back({rights[j].low[axis], false, j});
  std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.Key() < b.Key(); });

  std::vector<size_t> open_lefts, open_rights;
  for (const Start& start : starts) {
    const BoundingBox& box = start.is_left ? lefts[start.index] : rights[start.index];
    const std::vector<BoundingBox>& others = start.is_left ? rights : lefts;
    std::vector<size_t>& open = start.is_left ? open_rights : open_lefts;
    std::erase_if(open, [&](size_t other) { return others[other].high[axis] < start.low; });
    for (const size_t other : open) {
      if (!box.Overlaps(others[other])) continue;
      if (!(start.is_left ? visit(start.index, other) : visit(other, start.index))) return;
    }
    (start.is_left ? open_lefts : open_rights).push_back(start.index);
  }
}

}  // namespace tact::algebra
