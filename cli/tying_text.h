/// @file
/// A sequence of movement primitives as text: words, JSON, a page.
#pragma once

#include <string>

#include "algebra/knot/tying.h"

namespace tact::cli {

/// "the other end crosses over segment 3", "a loop at segment 2", "segment 2 slides under segment 5".
std::string MoveInWords(const knot::Move& move);
/// The object of `tact knot tie --json`, with a line's end.
std::string TyingToJson(const knot::Tying& tying);
/// A line a step, and what is known of shorter sequences.
std::string TyingToText(const knot::Tying& tying);
/// "3 steps, proved shortest".
std::string TyingSummary(const knot::Tying& tying);

}  // namespace tact::cli
