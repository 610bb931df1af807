#include "provers/claims/knot_outlines.h"

#include <map>
#include <mutex>

#include "algebra/knot/reducible.h"

namespace tact::provers {
namespace {

using knot::PData;

std::vector<PData> FindOutlines(int crossings) {
  std::vector<PData> outlines;
  ForEachPlanarPData(crossings, [&](const PData& p) {
    for (int i = 1; i <= p.columns(); ++i) {
      if (p.sign(i) > 0) return;
    }
    outlines.push_back(p);
  });
  std::sort(outlines.begin(), outlines.end());
  return outlines;
}

std::vector<PData> FindIrreducible(int crossings) {
  std::vector<PData> irreducible;
  for (const PData& p : Outlines(crossings)) {
    if ((crossings == 0 || p.over(1)) && IsIrreducible(p)) irreducible.push_back(p);
  }
  return irreducible;
}

// Each list is made once, whichever thread asks first.
class Lists {
 public:
  const std::vector<PData>& Get(int crossings, std::vector<PData> (*find)(int)) {
    const std::lock_guard lock(mutex_);
    const auto [list, is_new] = lists_.try_emplace(crossings);
    if (is_new) list->second = find(crossings);
    return list->second;
  }

 private:
  std::mutex mutex_;
  std::map<int, std::vector<PData>> lists_;
};

}  // namespace

const std::vector<PData>& Outlines(int crossings) {
  static Lists lists;
  return lists.Get(crossings, FindOutlines);
}

const std::vector<PData>& IrreducibleOutlines(int crossings) {
  static Lists lists;
  return lists.Get(crossings, FindIrreducible);
}

PData OutlineOf(const PData& p) {
  const int first = p.columns() == 0 ? -1 : p.turn(1);
  knot::PDataBuilder outline(p.columns());
  for (int i = 1; i <= p.columns(); ++i) outline.Add(p.sigma(i), p.turn(i) == first ? 1 : 2);
  return outline.Take();
}

std::vector<PData> RandomIrreducibleOutlines(Effort effort) {
  std::vector<PData> outlines;
  ForEachRandomRope(effort, [&](const PData& rope) {
    PData largest;
    for (const knot::Part& part : Split(rope)) largest = std::max(largest, part.p);
    if (largest.crossings() > 1) outlines.push_back(OutlineOf(largest));
  });
  return outlines;
}

OutlineTrial TryIrreducible(Effort effort, int least, const std::function<bool(const PData&)>& holds) {
  OutlineTrial trial;
  trial.least = least;
  trial.bound = OutlineBound(effort);
  const auto look = [&](const PData& p) {
    if (holds(p)) return;
    ++trial.failures;
    if (!trial.first || p < *trial.first) trial.first = p;
  };
  for (int n = least; n <= trial.bound; ++n) {
    for (const PData& p : IrreducibleOutlines(n)) {
      ++trial.outlines;
      look(p);
    }
  }
  for (const PData& p : RandomIrreducibleOutlines(effort)) {
    ++trial.random;
    look(p);
  }
  return trial;
}

std::string BoundOf(const OutlineTrial& trial) {
  return "all irreducible P-data of " + std::to_string(trial.least) + " to " + std::to_string(trial.bound) +
         " intersections, random ones of up to 12";
}

Outcome Judge(const OutlineTrial& trial, const std::string& evidence) {
  Outcome outcome;
  outcome.verdict = trial.failures == 0 && trial.outlines > 0 ? Verdict::kHoldsTo : Verdict::kRefuted;
  if (trial.first) outcome.no_certificate = "least failure " + Show(*trial.first);
  outcome.bound = BoundOf(trial);
  outcome.numbers = {{"P-data, heights and mirror images apart", trial.outlines},
                     {"random ones", trial.random},
                     {"failures", trial.failures}};
  outcome.evidence = evidence;
  return outcome;
}

}  // namespace tact::provers
