/// @file
/// Finite worlds and random P-data for tests, by the slow obvious ways.
#pragma once

#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"
#include "algebra/knot/reducible.h"

namespace tact::knot {

/// Every array of so many crossings that is P-data, planar or not: all pairings times all attributes.
inline void ForEachPData(int crossings, const std::function<void(const PData&)>& visit) {
  std::vector<int> sigma(2 * static_cast<size_t>(crossings), 0), attr(sigma.size(), 0);
  const std::function<void()> place = [&] {
    size_t first = 0;
    while (first < sigma.size() && sigma[first] != 0) ++first;
    if (first == sigma.size()) return visit(PData(sigma, attr));
    for (size_t mate = first + 1; mate < sigma.size(); ++mate) {
      if (sigma[mate] != 0) continue;
      sigma[first] = static_cast<int>(mate) + 1;
      sigma[mate] = static_cast<int>(first) + 1;
      for (int a = 1; a <= 4; ++a) {
        attr[first] = a;
        attr[mate] = MateAttribute(a);
        place();
      }
      sigma[first] = sigma[mate] = 0;
    }
  };
  place();
}

/// The planar ones, in the order of the loop above.
inline std::vector<PData> PlanarPData(int crossings) {
  std::vector<PData> all;
  ForEachPData(crossings, [&](const PData& p) {
    if (IsPlanar(p)) all.push_back(p);
  });
  return all;
}

/// A rope of so many crossings: random moves, most of them Cross moves.
inline PData RandomPData(std::mt19937_64& random, int crossings) {
  PData p;
  while (p.crossings() < crossings) {
    const auto moves = AllMoves(p, crossings);
    std::vector<Move> additions;
    const bool end = random() % 4 != 0;
    for (const Move& m : moves) {
      if (m.direction == MoveDirection::kAdd && (!end || m.kind == MoveKind::kCross)) additions.push_back(m);
    }
    p = Apply(p, additions[random() % additions.size()]);
  }
  return p;
}

/// The largest irreducible part of a rope of so many crossings.
inline PData RandomIrreduciblePData(std::mt19937_64& random, int crossings) {
  PData largest;
  for (const Part& part : Split(RandomPData(random, crossings))) largest = std::max(largest, part.p);
  return largest;
}

}  // namespace tact::knot
