#include "algebra/knot/reducible.h"

#include <algorithm>
#include <numeric>

#include "algebra/error.h"
#include "algebra/knot/columns.h"

namespace tact::knot {
namespace {

// A union-find forest; the root is the class's least member.
class Classes {
 public:
  explicit Classes(int count) : parent_(static_cast<size_t>(count)) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int Find(int x) {
    while (parent_[Index(x)] != x) x = parent_[Index(x)] = parent_[Index(parent_[Index(x)])];
    return x;
  }
  void Merge(int a, int b) {
    a = Find(a);
    b = Find(b);
    parent_[Index(std::max(a, b))] = std::min(a, b);
  }

 private:
  static size_t Index(int x) { return static_cast<size_t>(x); }
  std::vector<int> parent_;
};

}  // namespace

std::vector<ColumnInterval> ClosedIntervals(const PData& p) {
  std::vector<ColumnInterval> intervals;
  for (int first = 1; first <= p.columns(); ++first) {
    int furthest = first;
    for (int last = first; last <= p.columns() && p.sigma(last) >= first; ++last) {
      furthest = std::max(furthest, p.sigma(last));
      if (last > first && furthest <= last && (first != 1 || last != p.columns())) {
        intervals.push_back({first, last});
      }
    }
  }
  return intervals;
}

std::vector<int> InterlacementClasses(const PData& p) {
  // Intersections met once so far, by first columns, lie in runs that belong together. Closing one joins its run with
  // all later ones: those it interlaces.
  struct Run {
    int member;  // a column of the class
    int open;    // intersections in the run
  };
  Classes classes(p.columns() + 1);
  std::vector<Run> runs;
  for (int i = 1; i <= p.columns(); ++i) {
    const int mate = p.sigma(i);
    if (mate > i) {
      runs.push_back({i, 1});
      continue;
    }
    classes.Merge(mate, i);
    while (classes.Find(runs.back().member) != classes.Find(mate)) {
      const Run top = runs.back();
      runs.pop_back();
      classes.Merge(top.member, runs.back().member);
      runs.back().open += top.open;
    }
    if (--runs.back().open == 0) runs.pop_back();
  }
  std::vector<int> number(static_cast<size_t>(p.columns()) + 1, -1);
  int count = 0;
  for (int i = 1; i <= p.columns(); ++i) {
    const int root = classes.Find(i);
    if (root == i)
      number[static_cast<size_t>(i)] = count++;
    else
      number[static_cast<size_t>(i)] = number[static_cast<size_t>(root)];
  }
  return number;
}

bool IsIrreducible(const PData& p) {
  const std::vector<int> classes = InterlacementClasses(p);
  return *std::max_element(classes.begin(), classes.end()) <= 0;
}

std::vector<Part> Split(const PData& p) {
  const std::vector<int> classes = InterlacementClasses(p);
  const int count = *std::max_element(classes.begin(), classes.end()) + 1;
  std::vector<int> size(static_cast<size_t>(count), 0), place(classes.size(), 0);
  for (size_t i = 1; i < classes.size(); ++i) place[i] = ++size[static_cast<size_t>(classes[i])];
  std::vector<PDataBuilder> columns;
  std::vector<Part> parts(static_cast<size_t>(count));
  for (const int n : size) columns.emplace_back(n);
  for (int i = p.columns(); i >= 1; --i)
    parts[static_cast<size_t>(classes[static_cast<size_t>(i)])].segment = i;
  for (int i = 1; i <= p.columns(); ++i) {
    columns[static_cast<size_t>(classes[static_cast<size_t>(i)])].Add(place[static_cast<size_t>(p.sigma(i))],
                                                                      p.attr(i));
  }
  for (size_t part = 0; part < parts.size(); ++part) parts[part].p = columns[part].Take();
  return parts;
}

PData Join(const std::vector<Part>& parts) {
  PData joined;
  for (const Part& part : parts) joined = Insert(joined, part.segment, part.p);
  return joined;
}

PData Insert(const PData& y, int segment, const PData& x) {
  if (segment < 1 || segment > y.segments()) {
    throw PreconditionError("Insert: expected a segment from 1 to " + std::to_string(y.segments()) +
                            ", got " + std::to_string(segment));
  }
  const Renumbering to{segment, x.columns()};
  PDataBuilder joined(y.columns() + x.columns());
  for (int i = 1; i <= y.segments(); ++i) {
    if (i == segment) {
      for (int k = 1; k <= x.columns(); ++k) joined.Add(x.sigma(k) + segment - 1, x.attr(k));
    }
    if (i <= y.columns()) joined.Add(to(y.sigma(i)), y.attr(i));
  }
  return joined.Take();
}

}  // namespace tact::knot
