#include "algebra/solid/box_sweep.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace tact::algebra {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// ToDouble is right up to two units in the last place.
double Outwards(double value, double direction) {
  for (int i = 0; i < 4; ++i) value = std::nextafter(value, direction);
  return value;
}

int LongestAxis(const std::vector<Box>& boxes) {
  Box all;
  for (const Box& box : boxes) all.Add(box);
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

Box::Box() {
  low.fill(kInfinity);
  high.fill(-kInfinity);
}

void Box::Add(const Vector3& point) {
  const std::array<double, 3> rounded = ToDouble(point);
  for (size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], Outwards(rounded[i], -kInfinity));
    high[i] = std::max(high[i], Outwards(rounded[i], kInfinity));
  }
}

void Box::Add(const Box& other) {
  for (size_t i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

bool Box::Overlaps(const Box& other) const {
  for (size_t i = 0; i < 3; ++i) {
    if (high[i] < other.low[i] || other.high[i] < low[i]) return false;
  }
  return true;
}

void SweepOverlaps(const std::vector<Box>& lefts, const std::vector<Box>& rights,
                   const std::function<bool(size_t, size_t)>& visit) {
  const int axis = LongestAxis(rights);
  std::vector<Start> starts;
  starts.reserve(lefts.size() + rights.size());
  for (size_t i = 0; i < lefts.size(); ++i) starts.push_back({lefts[i].low[axis], true, i});
  for (size_t j = 0; j < rights.size(); ++j) starts.push_back({rights[j].low[axis], false, j});
  std::sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) { return a.Key() < b.Key(); });

  std::vector<size_t> open_lefts, open_rights;
  for (const Start& start : starts) {
    const Box& box = start.is_left ? lefts[start.index] : rights[start.index];
    const std::vector<Box>& others = start.is_left ? rights : lefts;
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
