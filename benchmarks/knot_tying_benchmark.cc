/// @file
/// Shortest sequences of moves for random ropes, each applied again in the same run.
/// Model   Ropes grow by random moves, three in four of them a Cross; heights are drawn again. Per number of intersections: the
///         median and the longest time, and how many lengths are proved shortest within the default budget.
/// Exit    0; 1 if a sequence does not tie its rope, or with --require SECONDS if one of 10 intersections takes longer.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <vector>

#include "algebra/knot/tying.h"

namespace tact::benchmarks {
namespace {

using knot::Move;
using knot::PData;

PData RandomRope(std::mt19937_64& random, int crossings) {
  PData p;
  while (p.crossings() < crossings) {
    const bool end = random() % 4 != 0;
    std::vector<Move> additions;
    for (const Move& move : AllMoves(p, crossings)) {
      if (move.direction == knot::MoveDirection::kAdd && (!end || move.kind == knot::MoveKind::kCross))
        additions.push_back(move);
    }
    p = Apply(p, additions[random() % additions.size()]);
  }
  std::vector<int> attr = p.AttrRow();
  for (int i = 1; i <= p.columns(); ++i) {
    if (p.sigma(i) < i || random() % 2 == 0) continue;
    attr[static_cast<size_t>(i) - 1] = knot::AttributeOf(!p.over(i), p.turn(i));
    attr[static_cast<size_t>(p.sigma(i)) - 1] = knot::MateAttribute(attr[static_cast<size_t>(i) - 1]);
  }
  return PData(p.SigmaRow(), attr);
}

bool Ties(const knot::Tying& tying, const PData& rope) {
  PData p;
  for (const knot::TyingStep& step : tying.steps) {
    if (FindMoveFault(p, step.move)) return false;
    p = Apply(p, step.move);
    if (p != step.reached) return false;
  }
  return tying.found && p == rope;
}

int Run(double require) {
  std::mt19937_64 random(5);
  bool good = true;
  std::printf("intersections  ropes  proved  median ms  longest ms  most P-data kept\n");
  for (const auto& [crossings, ropes] :
       {std::pair{6, 400}, {8, 400}, {10, 400}, {12, 100}, {14, 50}, {16, 10}}) {
    std::vector<double> times;
    int proved = 0;
    size_t states = 0;
    for (int k = 0; k < ropes; ++k) {
      const PData rope = RandomRope(random, crossings);
      const auto start = std::chrono::steady_clock::now();
      const knot::Tying tying = TieShortest(rope);
      times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
      proved += tying.proved_shortest() ? 1 : 0;
      states = std::max(states, tying.states);
      good = good && Ties(tying, rope);
    }
    std::sort(times.begin(), times.end());
    std::printf("%13d %6d %7d %10.3f %11.1f %17zu\n", crossings, ropes, proved, 1e3 * times[times.size() / 2],
                1e3 * times.back(), states);
    if (crossings == 10 && require > 0 && times.back() > require) good = false;
  }
  std::printf("%s\n",
              good ? "every sequence ties its rope" : "WRONG: a sequence does not tie its rope, or too slow");
  return good ? 0 : 1;
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  const bool require = argc == 3 && std::strcmp(argv[1], "--require") == 0;
  return tact::benchmarks::Run(require ? std::atof(argv[2]) : 0);
}
