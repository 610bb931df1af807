/// @file
/// Movement primitives of a rope as JSON.
/// Model   {"kind":"R1"|"R2"|"R3"|"Cross","direction":"add"|"remove"|"shift","segments":[...],"end":"selective"|"other"|null,
///         "selective_end":"same"|"swapped","attr":1..4|null,"order":"same"|"opposite"|null}: the fields of knot::Move
///         (algebra/knot/move.h). attr is null for R3; end is for Cross only, order for R2 only. A null may be left out, and
///         selective_end if it is "same"; nothing else may.
/// Errors  InputError `source:line:column: expected this, got that`: a key that is not known, one that the kind does not
///         have or lacks, too few or too many segments. Whether a P-data admits the move is another question.
#pragma once

#include <string>

#include "algebra/knot/move.h"

namespace tact::input {

knot::Explanation ParseMove(const std::string& text, const std::string& source);

/// Of a file ("-" is standard input), or of the text itself.
knot::Explanation ReadMove(const std::string& argument);

std::string MoveToJson(const knot::Explanation& explanation);

/// "R1", "R2", "R3", "Cross".
std::string_view NameOf(knot::MoveKind kind);
/// "add", "remove", "shift".
std::string_view NameOf(knot::MoveDirection direction);
/// "selective", "other"; "" for none.
std::string_view NameOf(knot::RopeEnd end);

}  // namespace tact::input
