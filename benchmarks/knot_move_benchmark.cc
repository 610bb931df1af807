/// @file
/// Moves between two P-data detected: time for ropes of 8 to 2000 intersections, random ones and those with most candidates; and
/// Reidemeister moves of closed diagrams by tact and by Regina, with the answers compared.
/// Model   Transitions are made beforehand. An answer is right if it holds the move that was made and each move in it gives the
///         second P-data. Times are medians over rounds.
/// Exit    0; 1 if an answer is wrong, or with --require if an aim is missed.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "algebra/knot/move_sites.h"
#include "benchmarks/random_rope.h"
#include "benchmarks/regina_knot.h"

namespace tact::benchmarks {
namespace {

using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;
using Clock = std::chrono::steady_clock;

struct Transition {
  PData before, after;
  Move move;
};

bool good = true;

void Fail(const std::string& what) {
  std::printf("  %s\n", what.c_str());
  good = false;
}

double Median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double Microseconds(Clock::time_point since) {
  return std::chrono::duration<double, std::micro>(Clock::now() - since).count();
}

Transition Made(const PData& p, const Move& move) { return {p, Apply(p, move), move}; }

// A move of that kind; of R3 if the rope has one.
std::optional<Transition> RandomTransition(Random& random, const PData& p, MoveKind kind) {
  if (kind == MoveKind::kR1) return Made(p, RandomR1(random, p));
  if (kind == MoveKind::kR2) return Made(p, RandomR2(random, p));
  if (kind == MoveKind::kCross) return Made(p, RandomCross(random, p));
  std::vector<Move> shifts;
  for (int i = 2; i <= p.columns(); ++i) {
    for (const bool forward : {true, false}) {
      if (const auto move = R3At(p, {i, forward})) shifts.push_back(*move);
    }
  }
  if (shifts.empty()) return std::nullopt;
  return Made(p, shifts[random() % shifts.size()]);
}

Transition Undone(const Transition& t) { return {t.after, t.before, Inverse(t.move)}; }

bool IsRight(const Transition& t) {
  const auto moves = DetectMoves(t.before, t.after);
  if (std::find(moves.begin(), moves.end(), t.move) == moves.end()) return false;
  // The longest answers are as long as the rope: a few of each will do.
  for (size_t k = 0; k < moves.size(); k += 1 + moves.size() / 8) {
    if (FindMoveFault(t.before, moves[k]) || Apply(t.before, moves[k]) != t.after) return false;
  }
  return true;
}

// Microseconds for one detection.
double TimeDetection(const std::vector<Transition>& transitions) {
  size_t wrong = 0, found = 0;
  for (const Transition& t : transitions) wrong += IsRight(t) ? 0 : 1;
  std::vector<double> rounds;
  for (int round = 0; round < 5; ++round) {
    const auto start = Clock::now();
    for (const Transition& t : transitions) found += DetectMoves(t.before, t.after).size();
    rounds.push_back(Microseconds(start) / static_cast<double>(transitions.size()));
  }
  if (wrong > 0 || found < 5 * transitions.size()) Fail(std::to_string(wrong) + " answers are wrong");
  return Median(rounds);
}

const std::pair<const char*, MoveKind> kKinds[] = {
    {"R1", MoveKind::kR1}, {"R2", MoveKind::kR2}, {"R3", MoveKind::kR3}, {"Cross", MoveKind::kCross}};

std::vector<Transition> RandomTransitions(Random& random, int crossings, MoveKind kind, size_t wanted) {
  std::vector<Transition> transitions;
  while (transitions.size() < wanted) {
    const PData p = RandomRope(random, crossings);
    const auto t = RandomTransition(random, p, kind);
    if (!t) continue;
    transitions.push_back(*t);
    if (t->move.direction == MoveDirection::kAdd) transitions.push_back(Undone(*t));
  }
  return transitions;
}

// n kinks in a row: a kink more may be any of n + 1.
Transition KinkChain(int crossings) {
  knot::PDataBuilder chain(2 * crossings);
  for (int k = 0; k < crossings; ++k) {
    chain.Add(2 * k + 2, 1);
    chain.Add(2 * k + 1, 2);
  }
  return Made(chain.Take(), {MoveKind::kR1, MoveDirection::kAdd, {crossings | 1, 0, 0}, {}, 1});
}

// The rope's first half woven over and along its second half, in the same or the opposite order: a lens more may be any of n + 1.
Transition Weave(int crossings, bool opposite) {
  const int n = 2 * crossings;
  knot::PDataBuilder weave(n);
  const auto mate = [&](int i) {
    return opposite ? n + 1 - i : i <= crossings ? i + crossings : i - crossings;
  };
  for (int i = 1; i <= n; ++i) {
    const int upper = std::min(i, mate(i));
    const bool plus = upper % 2 == 0;
    weave.Add(mate(i), (plus ? 3 : 1) + (i == upper ? 0 : 1));
  }
  const PData p = weave.Take();
  if (!IsPlanar(p)) Fail("a weave is no diagram");
  const int i = crossings / 2 | 1, j = opposite ? n + 2 - i : i + crossings;
  return Made(p, {MoveKind::kR2, MoveDirection::kAdd, {i, j, 0}, {}, 1, opposite});
}

// The rope's second half goes along under the first half by lenses on one side and comes back by lenses on the other side, between
// them: places for an R2 all along, whose second segments jump to and fro. Few moves explain a lens more at the near end.
Transition ToAndFro(int crossings) {
  const int quarter = crossings / 4, half = 4 * quarter + 1, n = 2 * half;
  std::vector<int> visited;
  for (int k = 0; k < quarter; ++k) visited.insert(visited.end(), {4 * k + 1, 4 * k + 2});
  visited.push_back(half);
  for (int k = quarter; k >= 1; --k) visited.insert(visited.end(), {4 * k, 4 * k - 1});
  std::vector<int> sigma(static_cast<size_t>(n)), attr(sigma.size());
  for (int k = 1; k <= half; ++k) {
    const int upper = visited[static_cast<size_t>(k) - 1], lower = half + k;
    sigma[static_cast<size_t>(upper) - 1] = lower;
    sigma[static_cast<size_t>(lower) - 1] = upper;
    attr[static_cast<size_t>(upper) - 1] = upper % 2 == 1 ? 1 : 3;
    attr[static_cast<size_t>(lower) - 1] = upper % 2 == 1 ? 2 : 4;
  }
  const PData p(sigma, attr);
  if (!IsPlanar(p)) Fail("a rope to and fro is no diagram");
  return Made(p, {MoveKind::kR2, MoveDirection::kAdd, {1, half + 1, 0}, {}, 1, false});
}

void PrintSizes() {
  std::printf("Detection, microseconds; n intersections before\n%-34s %9s %9s %9s %9s %12s %8s\n", "",
              "n = 8", "20", "200", "2000", "2000 / 200", "moves");
  const auto row = [](const std::string& name, const std::function<std::vector<Transition>(int)>& make,
                      bool linear) {
    std::vector<double> times;
    for (const int n : {8, 20, 200, 2000}) times.push_back(TimeDetection(make(n)));
    const Transition longest = make(2000)[0];
    std::printf("%-34s %9.3f %9.3f %9.2f %9.1f %12.1f %8zu\n", name.c_str(), times[0], times[1], times[2],
                times[3], times[3] / times[2], DetectMoves(longest.before, longest.after).size());
    if (times[1] >= 20) Fail("20 intersections take 20 microseconds or more");
    // Ten times as long; caches and the time per call make it more or less.
    if (linear && times[3] / times[2] > 25) Fail("not linear");
  };
  for (const auto& [name, kind] : kKinds) {
    const MoveKind k = kind;
    row(
        std::string("random, ") + name,
        [k](int n) {
          Random random(static_cast<unsigned>(n));
          return RandomTransitions(random, n, k, n > 500 ? 20 : n > 50 ? 200 : 2000);
        },
        true);
  }
  const auto repeat = [](const Transition& t) {
    return std::vector<Transition>(t.before.crossings() > 500 ? 20 : 200, t);
  };
  row(
      "kinks in a row, R1", [&](int n) { return repeat(KinkChain(n)); }, true);
  row(
      "to and fro, R2", [&](int n) { return repeat(ToAndFro(n)); }, true);
  row(
      "woven, same order, R2", [&](int n) { return repeat(Weave(n | 1, false)); }, true);
  row(
      "woven, opposite order, R2", [&](int n) { return repeat(Weave(n, true)); }, true);
}

struct Rates {
  double detect = 0, both = 0;  // transitions a second
};

// Mixed transitions at n = 8 on so many threads.
Rates MeasureRates(int threads) {
  Random random(8);
  std::vector<Transition> transitions;
  for (const auto& [name, kind] : kKinds) {
    const auto some = RandomTransitions(random, 8, kind, 25000);
    transitions.insert(transitions.end(), some.begin(), some.end());
  }
  std::shuffle(transitions.begin(), transitions.end(), random);
  const auto run = [&](const std::function<size_t(const Transition&)>& work) {
    std::vector<double> rounds;
    for (int round = 0; round < 5; ++round) {
      std::vector<std::thread> workers;
      std::vector<size_t> found(static_cast<size_t>(threads), 0);
      const auto start = Clock::now();
      for (int w = 0; w < threads; ++w) {
        workers.emplace_back([&, w] {
          size_t sum = 0;
          for (size_t k = static_cast<size_t>(w); k < transitions.size(); k += static_cast<size_t>(threads))
            sum += work(transitions[k]);
          found[static_cast<size_t>(w)] = sum;
        });
      }
      for (std::thread& worker : workers) worker.join();
      rounds.push_back(static_cast<double>(transitions.size()) / (Microseconds(start) / 1e6));
      size_t all = 0;
      for (const size_t f : found) all += f;
      if (all < transitions.size()) Fail("a transition was not explained");
    }
    return Median(rounds);
  };
  Rates rates;
  rates.detect = run([](const Transition& t) { return DetectMoves(t.before, t.after).size(); });
  rates.both = run([](const Transition& t) { return DetectMoves(t.before, Apply(t.before, t.move)).size(); });
  return rates;
}

void PrintRates(bool require) {
  constexpr double kAim = 1e6;
  std::printf("\nMixed random transitions, n = 8, a second (aim: 10^6 on 2 threads)\n");
  for (const int threads : {1, 2}) {
    const Rates rates = MeasureRates(threads);
    std::printf("%d thread%s detect %.3g (%.2f of the aim), apply and detect %.3g (%.2f of the aim)\n",
                threads, threads == 1 ? " " : "s", rates.detect, rates.detect / kAim, rates.both,
                rates.both / kAim);
    if (require && threads == 2 && rates.detect < kAim) Fail("fewer than 10^6 a second");
  }
}

// The removals and shifts that a closed diagram's own arcs admit; columns from 1, the joined end segments left out.
size_t CountByTact(const PData& p) {
  size_t count = 0;
  for (int i = 1; i < p.columns(); ++i) {
    count += p.sigma(i) == i + 1 ? 1 : 0;
    count += R2RemovalAt(p, i) ? 1 : 0;
    if (!p.over(i) || !p.over(i + 1)) continue;
    for (const bool forward : {true, false}) count += R3At(p, {i + 1, forward}) ? 1 : 0;
  }
  return count;
}

size_t CountByRegina(int crossings, ReginaKnot& knot) {
  size_t count = 0;
  for (int c = 0; c < crossings; ++c)
    count += (knot.RemoveR1(c, false) ? 1 : 0) + (knot.RemoveR2(c, false) ? 1 : 0) +
             (knot.ShiftR3(c, 0, false) ? 1 : 0) + (knot.ShiftR3(c, 1, false) ? 1 : 0);
  return count;
}

void PrintRegina(size_t diagrams) {
  Random random(3);
  std::vector<PData> ropes;
  std::vector<Move> moves;
  while (ropes.size() < diagrams) {
    const PData p = LeadTogether(random, RandomRope(random, 8 + static_cast<int>(ropes.size() % 13)));
    Move move = RandomR2(random, p);
    if (!EndsShareAFace(Apply(p, move)) || move.segments[0] == move.segments[1] || move.segments[0] == 1 ||
        move.segments[1] == p.segments())
      continue;
    ropes.push_back(p);
    moves.push_back(move);
  }
  // Regina also sees what the joined end segments bound and some pairs that are no lens (regina_knot.h): never fewer moves.
  size_t ours = 0, theirs = 0, fewer = 0, differ = 0;
  double find = 0, regina_find = 0, make = 0, regina_make = 0;
  for (size_t k = 0; k < ropes.size(); ++k) {
    const PData& p = ropes[k];
    const Move& move = moves[k];
    auto start = Clock::now();
    const size_t by_tact = CountByTact(p);
    find += Microseconds(start);
    ReginaKnot knot(p);
    start = Clock::now();
    const size_t by_regina = CountByRegina(p.crossings(), knot);
    regina_find += Microseconds(start);
    ours += by_tact;
    theirs += by_regina;
    fewer += by_regina < by_tact ? 1 : 0;

    start = Clock::now();
    const PData q = Apply(p, move);  // checks first
    make += Microseconds(start);
    const knot::R2Site site = SiteOfR2(move);
    const bool first_over = move.attr % 2 == 1;
    const knot::Dart upper = first_over ? site.i : site.j, lower = first_over ? site.j : site.i;
    start = Clock::now();
    const bool done =
        knot.AddR2(upper.segment - 1, upper.forward ? 0 : 1, lower.segment - 1, lower.forward ? 0 : 1, true);
    regina_make += Microseconds(start);
    differ += done && knot.Signature() == ReginaKnot(q).Signature() ? 0 : 1;
  }
  const double count = static_cast<double>(ropes.size());
  std::printf("\n%zu random closed diagrams of 8 intersections on, microseconds\n", ropes.size());
  std::printf("R1, R2 to remove and R3 found   tact %7.3f (%zu)  Regina %7.3f (%zu)  Regina/tact %.1f\n",
              find / count, ours, regina_find / count, theirs, regina_find / find);
  std::printf("an R2 checked and added         tact %7.3f       Regina %7.3f       Regina/tact %.1f\n",
              make / count, regina_make / count, regina_make / make);
  if (fewer > 0) Fail(std::to_string(fewer) + " diagrams where Regina finds fewer moves");
  if (differ > 0) Fail(std::to_string(differ) + " diagrams that differ after the move");
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  using namespace tact::benchmarks;
  try {
    size_t diagrams = 100000;
    bool require = false;
    for (int i = 1; i < argc; ++i) {
      if (std::strcmp(argv[i], "--require") == 0) {
        require = true;
      } else if (std::strcmp(argv[i], "--diagrams") == 0 && i + 1 < argc) {
        diagrams = std::strtoull(argv[++i], nullptr, 10);
      } else {
        throw std::invalid_argument(std::string("expected --require or --diagrams N, got ") + argv[i]);
      }
    }
    PrintSizes();
    PrintRates(require);
    PrintRegina(diagrams);
    return good ? EXIT_SUCCESS : EXIT_FAILURE;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
