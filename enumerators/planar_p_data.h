/// @file
/// All P-data of a sphere with so many intersections, each once, in an order that does not vary.
/// Model   Removing the last column and its mate (a Cross move of the other end) leads from every P-data down to the straight
///         rope; its inverses, one for each dart of the tip's face and each height, build each P-data once, depth first.
/// Cost    O(n) a P-data; nothing is stored. Without heights they are as many as OEIS A373325 says, 2^n times as many with.
#pragma once

#include "algebra/knot/columns.h"
#include "algebra/knot/faces.h"

namespace tact::enumerators {

namespace planar_p_data_detail {
template <typename Visit>
void Grow(const knot::PData& p, int more, const Visit& visit) {
  if (more == 0) return visit(p);
  const knot::Dart tip{p.segments(), true};
  const int n = p.columns();
  knot::Dart d = tip;
  do {
    for (const bool over : {true, false}) {
      // The tip leaves the dart's left side: the dart's own direction sees it go to the right.
      const int attr = knot::AttributeOf(over, d.forward ? 1 : -1);
      Grow(InsertColumns(p, {d.segment, 1},
                         {{d.segment, n + 2, knot::MateAttribute(attr)}, {n + 2, d.segment, attr}}),
           more - 1, visit);
    }
    d = NextDart(p, d);
  } while (d != tip);
}
}  // namespace planar_p_data_detail

/// Visits each planar P-data with exactly that many intersections once, in an order that does not vary.
template <typename Visit>
void ForEachPlanarPData(int crossings, const Visit& visit) {
  planar_p_data_detail::Grow(knot::PData(), crossings, visit);
}
/// With up to that many.
template <typename Visit>
void ForEachPlanarPDataTo(int crossings, const Visit& visit) {
  for (int n = 0; n <= crossings; ++n) ForEachPlanarPData(n, visit);
}

}  // namespace tact::enumerators
