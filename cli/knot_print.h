/// @file
/// P-data and moves for people.
#pragma once

#include <string>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"

namespace tact::cli {

/// "1 intersection", "3 intersections".
std::string Counted(int count, const std::string& thing);
/// The last two rows of the thesis' notation on one line, "4 5 6 1 2 3 / 3 4 3 4 3 4"; "/" of the straight rope. It reads
/// back as the P-data.
std::string TwoRows(const knot::PData& p);
/// All three, a line each; "/" of the straight rope.
std::string ThreeRows(const knot::PData& p);
/// "2 under/-"
std::string AttributeText(int attr);
/// "+3" along the rope, "-3" against it.
std::string DartText(knot::Dart d);
/// "R2 add: segments 2 and 5, same order, attribute 1 over/-"
std::string MoveText(const knot::Explanation& explanation);

}  // namespace tact::cli
