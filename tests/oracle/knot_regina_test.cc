/// @file
/// Reidemeister moves of closed diagrams compared with Regina's links: which are possible, and what comes out.
/// Model   A rope whose ends lie on one face is closed there. Moves of the closed diagram are those of the rope and, since the
///         joined end segments are an arc like the others then, those of the rope that is read from one column later.
///         Regina takes away some pairs of crossings of one sign that bound no face (regina_knot.h); those are counted apart.
///         Regina adds no R2 of an arc with itself; those are left out. A face that holds both ends falls into two when they
///         are joined: an R2 that would part the ends is none of the closed diagram.
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <set>
#include <stdexcept>
#include <string>

#include "algebra/knot/columns.h"
#include "algebra/knot/move_sites.h"
#include "benchmarks/random_rope.h"
#include "benchmarks/regina_knot.h"

namespace tact::oracle {
namespace {

using benchmarks::CrossingOfColumns;
using benchmarks::Random;
using benchmarks::ReginaKnot;
using knot::Move;
using knot::MoveDirection;
using knot::MoveKind;
using knot::PData;

long long differences = 0;

void Expect(bool agrees, const PData& p, const std::string& what) {
  if (agrees) return;
  if (++differences <= 5) std::cout << "differs: " << what << " of " << p.ToJson() << "\n";
}

// The same closed diagram read from its second column on.
PData ReadLater(const PData& p) {
  const int n = p.columns();
  const auto to = [n](int column) { return column == 1 ? n : column - 1; };
  knot::PDataBuilder rotated(n);
  for (int i = 2; i <= n + 1; ++i) {
    const int from = i > n ? 1 : i;
    rotated.Add(to(p.sigma(from)), p.attr(from));
  }
  return rotated.Take();
}

// What tells a move of a closed diagram apart for Regina.
struct Places {
  std::set<int> r1, r2;
  std::set<std::pair<int, int>> r3;
};

int CrossingAt(const std::vector<int>& crossings, int column) {
  return crossings[static_cast<size_t>(column) - 1];
}

// Adds the removals and shifts of a rope; crossings by column.
void AddPlaces(const PData& p, const std::vector<int>& crossings, Places& places) {
  for (const Move& move : AllMoves(p, p.crossings())) {
    const int i = move.segments[0], j = move.segments[1];
    if (move.direction == MoveDirection::kRemove && move.kind == MoveKind::kR1)
      places.r1.insert(CrossingAt(crossings, i));
    if (move.direction == MoveDirection::kRemove && move.kind == MoveKind::kR2)
      places.r2.insert(CrossingAt(crossings, p.over(i) ? i : j + 2));
    if (move.kind != MoveKind::kR3) continue;
    for (const bool forward : {true, false}) {
      if (R3At(p, {i, forward}) == move) places.r3.emplace(CrossingAt(crossings, i - 1), forward ? 0 : 1);
    }
  }
}

Places ClosedPlaces(const PData& p) {
  Places places;
  const std::vector<int> crossings = CrossingOfColumns(p);
  AddPlaces(p, crossings, places);
  std::vector<int> later(crossings.begin() + 1, crossings.end());
  later.push_back(crossings[0]);
  AddPlaces(ReadLater(p), later, places);
  return places;
}

struct Counts {
  long long diagrams = 0, r1 = 0, r2 = 0, r3 = 0, added_r2 = 0, itself = 0, parted = 0, applied = 0,
            no_lens = 0;
};

Places ReginaPlaces(const PData& p, ReginaKnot& knot, Counts& counts) {
  Places places;
  for (int c = 0; c < p.crossings(); ++c) {
    if (knot.RemoveR1(c, false)) places.r1.insert(c);
    if (knot.RemoveR2(c, false)) {
      ReginaKnot pulled(knot);
      pulled.RemoveR2(c, true);
      if (pulled.Writhe() == knot.Writhe()) {
        places.r2.insert(c);
      } else {
        ++counts.no_lens;
      }
    }
    for (const int side : {0, 1}) {
      if (knot.ShiftR3(c, side, false)) places.r3.emplace(c, side);
    }
  }
  return places;
}

// The column that a segment's closed arc starts at.
int ArcStart(const PData& p, int segment) { return segment == 1 ? p.columns() : segment - 1; }

struct R2Arcs {
  int upper, upper_side, lower, lower_side;
  friend auto operator<=>(const R2Arcs&, const R2Arcs&) = default;
};

R2Arcs ArcsOfR2(const PData& p, const Move& move) {
  const knot::R2Site site = SiteOfR2(move);
  const bool first_over = move.attr % 2 == 1;
  const knot::Dart upper = first_over ? site.i : site.j, lower = first_over ? site.j : site.i;
  return {ArcStart(p, upper.segment), upper.forward ? 0 : 1, ArcStart(p, lower.segment),
          lower.forward ? 0 : 1};
}

std::set<R2Arcs> ReginaAdditions(const PData& p, ReginaKnot& knot) {
  std::set<R2Arcs> arcs;
  for (int upper = 1; upper <= p.columns(); ++upper) {
    for (int lower = 1; lower <= p.columns(); ++lower) {
      for (const int sides : {0, 1, 2, 3}) {
        const R2Arcs a{upper, sides & 1, lower, sides >> 1};
        if (upper != lower && knot.AddR2(a.upper, a.upper_side, a.lower, a.lower_side, false)) arcs.insert(a);
      }
    }
  }
  return arcs;
}

// One move of the rope done by both: the diagrams must be the same.
void CompareMove(const PData& p, const ReginaKnot& knot, const Move& move, Counts& counts) {
  const PData q = Apply(p, move);
  const std::vector<int> crossings = CrossingOfColumns(p);
  ReginaKnot moved(knot);
  bool done = false;
  const int i = move.segments[0], j = move.segments[1];
  if (move.kind == MoveKind::kR3) {
    done = moved.ShiftR3(CrossingAt(crossings, i - 1), R3At(p, {i, true}) == move ? 0 : 1, true);
  } else if (move.direction == MoveDirection::kRemove) {
    done = move.kind == MoveKind::kR1 ? moved.RemoveR1(CrossingAt(crossings, i), true)
                                      : moved.RemoveR2(CrossingAt(crossings, p.over(i) ? i : j + 2), true);
  } else if (move.kind == MoveKind::kR1) {
    // The loop lies on the side that its end comes back from.
    const bool over = move.attr % 2 == 1, plus = move.attr > 2;
    done = moved.AddR1(ArcStart(p, i), over == plus ? 1 : 0, plus ? 1 : -1, true);
  } else {
    const R2Arcs a = ArcsOfR2(p, move);
    done = moved.AddR2(a.upper, a.upper_side, a.lower, a.lower_side, true);
  }
  Expect(done && moved.Signature() == ReginaKnot(q).Signature(), p, "a move");
  ++counts.applied;
}

void Compare(Random& random, const PData& p, Counts& counts) {
  ++counts.diagrams;
  ReginaKnot knot(p);
  const Places ours = ClosedPlaces(p), theirs = ReginaPlaces(p, knot, counts);
  Expect(ours.r1 == theirs.r1, p, "R1");
  Expect(ours.r2 == theirs.r2, p, "R2");
  Expect(ours.r3 == theirs.r3, p, "R3");
  counts.r1 += static_cast<long long>(theirs.r1.size());
  counts.r2 += static_cast<long long>(theirs.r2.size());
  counts.r3 += static_cast<long long>(theirs.r3.size());

  std::set<R2Arcs> additions;
  std::vector<Move> moves;  // of the rope and of the closed diagram
  for (const Move& move : AllMoves(p)) {
    if (move.kind == MoveKind::kCross) continue;
    if (move.kind == MoveKind::kR2 && move.direction == MoveDirection::kAdd) {
      const R2Arcs arcs = ArcsOfR2(p, move);
      if (!benchmarks::EndsShareAFace(Apply(p, move))) {
        ++counts.parted;
        continue;
      }
      if (arcs.upper == arcs.lower) {
        ++counts.itself;
        continue;
      }
      additions.insert(arcs);
    }
    moves.push_back(move);
  }
  Expect(additions == ReginaAdditions(p, knot), p, "R2 to add");
  counts.added_r2 += static_cast<long long>(additions.size());
  for (int k = 0; k < 6; ++k) CompareMove(p, knot, moves[random() % moves.size()], counts);
  for (const Move& move : moves) {
    if (move.kind == MoveKind::kR3) CompareMove(p, knot, move, counts);
  }
}

// Whether heights apart some signs make the pairing a diagram whose ends share a face.
bool AnySigns(const PData& p) {
  const std::vector<int> crossings = CrossingOfColumns(p);
  for (unsigned signs = 0; signs < 1u << p.crossings(); ++signs) {
    knot::PDataBuilder q(p.columns());
    for (int i = 1; i <= p.columns(); ++i)
      q.Add(p.sigma(i), (signs >> CrossingAt(crossings, i) & 1u ? 3 : 1) + (p.over(i) ? 0 : 1));
    const PData built = q.Take();
    if (IsPlanar(built) && benchmarks::EndsShareAFace(built)) return true;
  }
  return false;
}

void CompareValidity(Random& random, long long& realisable, long long& not_realisable) {
  const int crossings = 1 + benchmarks::Below(random, 7);
  std::vector<int> order;
  for (int i = 0; i < 2 * crossings; ++i) order.push_back(i);
  PData p = benchmarks::LeadTogether(random, benchmarks::RandomRope(random, crossings));
  if (random() % 2 == 0) {  // any pairing; else a diagram's
    std::shuffle(order.begin(), order.end(), random);
    std::vector<int> sigma(order.size()), attr(order.size(), 1);
    for (size_t k = 0; k < order.size(); k += 2) {
      sigma[static_cast<size_t>(order[k])] = order[k + 1] + 1;
      sigma[static_cast<size_t>(order[k + 1])] = order[k] + 1;
      attr[static_cast<size_t>(order[k + 1])] = 2;
    }
    p = PData(sigma, attr);
  }
  if (p.crossings() > 10) return;
  const std::vector<int> of = CrossingOfColumns(p);
  std::vector<int> gauss;
  for (int i = 1; i <= p.columns(); ++i) gauss.push_back((p.over(i) ? 1 : -1) * (CrossingAt(of, i) + 1));
  const bool regina = ReginaKnot::IsRealisable(gauss);
  Expect(regina == AnySigns(p), p, "validity");
  ++(regina ? realisable : not_realisable);
}

int Run(long long diagrams, unsigned long long seed) {
  Random random(seed);
  Counts counts;
  for (long long k = 0; k < diagrams; ++k) {
    const PData p =
        benchmarks::LeadTogether(random, benchmarks::RandomRope(random, 1 + static_cast<int>(k % 12)));
    if (p.columns() > 0) Compare(random, p, counts);
  }
  long long realisable = 0, not_realisable = 0;
  for (long long k = 0; k < diagrams; ++k) CompareValidity(random, realisable, not_realisable);
  std::cout << counts.diagrams << " closed diagrams: " << counts.r1 << " R1, " << counts.r2 << " R2, "
            << counts.r3 << " R3, " << counts.added_r2 << " R2 to add; left out " << counts.itself
            << " of an arc with itself, " << counts.no_lens << " pairs of one sign, " << counts.parted
            << " that part the ends; " << counts.applied << " moves done by both\n"
            << realisable << " Gauss codes of diagrams, " << not_realisable << " of none\n"
            << differences << " differences\n";
  const bool varied = counts.r1 > 0 && counts.r2 > 0 && counts.r3 > 0 && counts.itself > 0 &&
                      counts.parted > 0 && realisable > 0 && not_realisable > 0;
  if (!varied) std::cout << "the generator lacks variety\n";
  return differences == 0 && varied ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::oracle

int main(int argc, char** argv) {
  try {
    long long diagrams = 1000;
    unsigned long long seed = 1;
    for (int i = 1; i + 1 < argc; i += 2) {
      const std::string name = argv[i];
      if (name == "--diagrams") {
        diagrams = std::atoll(argv[i + 1]);
      } else if (name == "--seed") {
        seed = std::strtoull(argv[i + 1], nullptr, 10);
      } else {
        throw std::invalid_argument("expected --diagrams N or --seed S, got " + name);
      }
    }
    return tact::oracle::Run(diagrams, seed);
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
}
