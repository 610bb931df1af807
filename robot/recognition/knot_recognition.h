/// @file
/// A knot-tying task as a sequence of P-data: which movement primitive led from each to the next [thesis, 5.3.5, 5.4.2].
/// Model   Each P-data was read off from one of the rope's ends, maybe not always the same one. The first one's end is the
///         selective end; each other P-data is taken as given or replaced by its equivalent P-data, so that the fewest
///         transitions are without an explanation and, among these choices, the fewest P-data are replaced.
/// Pre     all P-data are planar.
/// Cost    four detections of O(n) a transition.
#pragma once

#include <vector>

#include "algebra/knot/move.h"

namespace tact::recognition {

enum class EndRead {
  kAsGiven,
  kSwapped,  // the P-data was read off from the other end
  kEither,   // it is its own equivalent: nobody can tell
};

struct KnotRecognition {
  std::vector<EndRead> ends;  // of each P-data
  std::vector<std::vector<knot::Move>>
      transitions;  // every single move that explains it, ends repaired; none: no one does
};

KnotRecognition RecognizeKnot(const std::vector<knot::PData>& sequence);

}  // namespace tact::recognition
