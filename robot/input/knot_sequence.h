/// @file
/// The P-data that arguments name, whether they are texts of P-data or curves, one or the steps of a task.
/// Model   An argument is a file, a name of examples/knots or the text itself (knot_text.h); it holds one P-data, P-data in
///         JSON a line, or rope curves (curve_text.h). All curves are seen from one view.
/// Errors  InputError `source:line:column: expected this, got that`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "robot/input/curve_text.h"

namespace tact::input {

struct ReadKnot {
  knot::PData p;
  std::string place;    // "source:line:column", for messages
  size_t argument = 0;  // which one it comes from
};

struct KnotSequence {
  std::vector<ReadKnot> knots;
  /// What was chosen, if a view was asked for and curves were among the arguments.
  std::optional<knot::ProjectedCurves> chosen;
};

KnotSequence ReadKnotSequence(const std::vector<std::string>& arguments, const CurveView& view);

}  // namespace tact::input
