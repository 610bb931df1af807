// Which single moves turn one P-data into another.
#include <algorithm>
#include <optional>
#include <utility>

#include "algebra/knot/column_match.h"
#include "algebra/knot/move_sites.h"
#include "algebra/knot/r2_places.h"

namespace tact::knot {
namespace {

// How many columns agree from the left, read with mates to the left only; what is to the right may still be renumbered.
int CommonPrefix(const PData& a, const PData& b) {
  int k = 1;
  for (; k <= a.columns(); ++k) {
    if (a.attr(k) != b.attr(k)) break;
    if (a.sigma(k) < k ? b.sigma(k) != a.sigma(k) : b.sigma(k) < k) break;
  }
  return k - 1;
}

// The same from the right.
int CommonSuffix(const PData& a, const PData& b) {
  const int n = a.columns(), more = b.columns() - n;
  int k = n;
  for (; k >= 1; --k) {
    if (a.attr(k) != b.attr(k + more)) break;
    if (a.sigma(k) > k ? b.sigma(k + more) != a.sigma(k) + more : b.sigma(k + more) > k + more) break;
  }
  return n - k;
}

void FindR1(const PData& a, const PData& b, MoveDirection direction, std::vector<Move>& moves) {
  const int low = a.segments() - CommonSuffix(a, b), high = CommonPrefix(a, b) + 1;
  ColumnMatch match(a, b);
  for (int i = low; i <= high; ++i) {
    const Move move{MoveKind::kR1, direction, {i, 0, 0}, {}, b.attr(i)};
    if (b.sigma(i) == i + 1 && match.EqualAt(PlacesOf(move))) moves.push_back(move);
  }
}

void FindR2(const PData& a, const PData& b, MoveDirection direction, std::vector<Move>& moves) {
  constexpr int kCompared = 2;  // so many places are compared before it pays to look at all of them
  const int low = a.segments() - CommonSuffix(a, b), high = CommonPrefix(a, b) + 1;
  std::optional<R2Places> places;
  int tried = 0;
  for (int i = 1; i <= high; ++i) {
    std::optional<Move> move = R2RemovalAt(b, i);
    if (!move || move->segments[1] < low) continue;
    if (++tried > kCompared && !places) places.emplace(a, b);
    if (places ? !places->EqualAt(i, move->segments[1]) : !EqualBut(a, PlacesOf(*move), b)) continue;
    move->direction = direction;
    moves.push_back(*move);
  }
}

void FindCross(const PData& a, const PData& b, MoveDirection direction, std::vector<Move>& moves) {
  const int n = b.columns();
  Move selective{MoveKind::kCross, direction, {b.sigma(1) - 1, 0, 0}, RopeEnd::kSelective, b.attr(1)};
  Move other{MoveKind::kCross, direction, {b.sigma(n), 0, 0}, RopeEnd::kOther, b.attr(n)};
  if (other < selective) std::swap(selective, other);
  for (const Move& move : {selective, other}) {
    if (EqualBut(a, PlacesOf(move), b)) moves.push_back(move);
  }
}

// The moves that add columns to a and give b, in canonical order; they are what removes them from b.
void FindAdditions(const PData& a, const PData& b, MoveDirection direction, std::vector<Move>& moves) {
  if (b.columns() == a.columns() + 2) {
    FindR1(a, b, direction, moves);
    FindCross(a, b, direction, moves);
  } else {
    FindR2(a, b, direction, moves);
  }
}

// Two P-data that an R3 turns into each other differ in the six columns of its segments' ends and nowhere else.
void FindShift(const PData& a, const PData& b, std::vector<Move>& moves) {
  std::array<int, 6> differing{};
  size_t count = 0;
  for (int i = 1; i <= a.columns(); ++i) {
    if (a.sigma(i) == b.sigma(i) && a.attr(i) == b.attr(i)) continue;
    if (count == 6) return;
    differing[count++] = i;
  }
  if (count != 6) return;
  for (size_t pair = 0; pair < 6; pair += 2) {
    if (differing[pair + 1] != differing[pair] + 1) return;
  }
  const auto swapped = [&](int column) {
    for (size_t k = 0; k < 6; ++k) {
      if (differing[k] == column) return differing[k ^ 1];
    }
    return column;
  };
  for (const int i : differing) {
    if (b.sigma(i) != swapped(a.sigma(swapped(i))) || b.attr(i) != a.attr(swapped(i))) return;
  }
  for (const bool forward : {false, true}) {
    const auto move = R3At(a, {differing[1], forward});
    if (!move) continue;
    std::array<int, 3> sorted = move->segments;
    std::sort(sorted.begin(), sorted.end());
    if (sorted == std::array<int, 3>{differing[1], differing[3], differing[5]}) moves.push_back(*move);
  }
}

}  // namespace

std::vector<Move> DetectMoves(const PData& a, const PData& b) {
  std::vector<Move> moves;
  const int more = b.columns() - a.columns();
  if (more == 2 || more == 4) FindAdditions(a, b, MoveDirection::kAdd, moves);
  if (more == -2 || more == -4) FindAdditions(b, a, MoveDirection::kRemove, moves);
  if (more == 0) FindShift(a, b, moves);
  return moves;
}

std::vector<Explanation> ExplainTransition(const PData& a, const PData& b) {
  std::vector<Explanation> all;
  for (const Move& move : DetectMoves(a, b)) all.push_back({move, false});
  for (const Move& move : DetectMoves(a, EquivalentPData(b))) all.push_back({move, true});
  return all;
}

}  // namespace tact::knot
