/// @file
/// Random ropes, ropes whose ends lie on one face, and worst cases for detection; from a seed.
/// Cost    O(n) a move.
#pragma once

#include <random>
#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"

namespace tact::benchmarks {

using Random = std::mt19937_64;

inline int Below(Random& random, int bound) {
  return static_cast<int>(random() % static_cast<unsigned>(bound));
}

inline std::vector<knot::Dart> FaceWalk(const knot::PData& p, knot::Dart first) {
  std::vector<knot::Dart> walk;
  knot::Dart d = first;
  do {
    walk.push_back(d);
    d = NextDart(p, d);
  } while (d != first);
  return walk;
}

inline knot::Dart RandomDart(Random& random, const knot::PData& p) {
  return {1 + Below(random, p.segments()), Below(random, 2) == 1};
}

/// The Cross move that leads the end over or under a dart of its face.
inline knot::Move CrossOver(knot::Dart d, knot::RopeEnd end, bool over) {
  const int turn = d.forward == (end == knot::RopeEnd::kOther) ? 1 : -1;
  return {knot::MoveKind::kCross,
          knot::MoveDirection::kAdd,
          {d.segment, 0, 0},
          end,
          knot::AttributeOf(over, turn)};
}

inline knot::Move RandomCross(Random& random, const knot::PData& p) {
  const auto end = Below(random, 2) == 1 ? knot::RopeEnd::kSelective : knot::RopeEnd::kOther;
  const bool selective = end == knot::RopeEnd::kSelective;
  const auto walk = FaceWalk(p, selective ? knot::Dart{1, false} : knot::Dart{p.segments(), true});
  return CrossOver(walk[random() % walk.size()], end, Below(random, 2) == 1);
}

inline knot::Move RandomR1(Random& random, const knot::PData& p) {
  return {knot::MoveKind::kR1,
          knot::MoveDirection::kAdd,
          {1 + Below(random, p.segments()), 0, 0},
          {},
          1 + Below(random, 4)};
}

inline knot::Move RandomR2(Random& random, const knot::PData& p) {
  const auto walk = FaceWalk(p, RandomDart(random, p));
  knot::Dart i = walk[random() % walk.size()], j = walk[random() % walk.size()];
  if (i.segment > j.segment) std::swap(i, j);
  const int attr = knot::AttributeOf(Below(random, 2) == 1, j.forward ? 1 : -1);
  return {knot::MoveKind::kR2,   knot::MoveDirection::kAdd, {i.segment, j.segment, 0}, {}, attr,
          i.forward == j.forward};
}

/// With just so many intersections.
inline knot::PData RandomRope(Random& random, int crossings) {
  knot::PData p;
  while (p.crossings() < crossings) {
    const int kind = Below(random, 8);
    if (kind < 5) {
      p = Apply(p, RandomCross(random, p));
    } else if (kind < 6) {
      p = Apply(p, RandomR1(random, p));
    } else if (p.crossings() + 2 <= crossings) {
      p = Apply(p, RandomR2(random, p));
    }
  }
  return p;
}

inline bool EndsShareAFace(const knot::PData& p) {
  for (const knot::Dart d : FaceWalk(p, {1, false})) {
    if (d == knot::Dart{p.segments(), true}) return true;
  }
  return false;
}

/// p with its other end led, by Cross moves through the fewest faces, to the selective end's face.
inline knot::PData LeadTogether(Random& random, knot::PData p) {
  while (!EndsShareAFace(p)) {
    const knot::Faces faces(p);
    // Distance of each face from the selective end's, breadth first.
    std::vector<int> distance(static_cast<size_t>(faces.count()), -1), queue = {faces.left_of({1, false})};
    distance[static_cast<size_t>(queue[0])] = 0;
    for (size_t head = 0; head < queue.size(); ++head) {
      for (const knot::Dart d : faces.walk(queue[head])) {
        const int next = faces.left_of(Opposite(d));
        if (distance[static_cast<size_t>(next)] >= 0) continue;
        distance[static_cast<size_t>(next)] = distance[static_cast<size_t>(queue[head])] + 1;
        queue.push_back(next);
      }
    }
    const int here = faces.left_of({p.segments(), true});
    for (const knot::Dart d : faces.walk(here)) {
      const int there = faces.left_of(Opposite(d));
      if (distance[static_cast<size_t>(there)] >= distance[static_cast<size_t>(here)]) continue;
      p = Apply(p, CrossOver(d, knot::RopeEnd::kOther, Below(random, 2) == 1));
      break;
    }
  }
  return p;
}

}  // namespace tact::benchmarks
