/// @file
/// Rope curves from XYZ text: one point a line.
/// Model   A line holds three numbers, decimals or p/q, set apart by blanks, commas or semicolons; from a '#' on it is a
///         comment. The first point is the selective end. A line of three dashes or more, "---", ends a curve and begins
///         the next: the steps of a task in one text. Empty lines mean nothing.
/// Exact   a number is the decimal that it writes.
/// Errors  InputError `source:line:column: expected this, got that`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "algebra/knot/curve_views.h"
#include "robot/input/text_token.h"

namespace tact::input {

struct CurveText {
  knot::Curve points;
  std::vector<size_t> offsets;  // where each point begins in the text; there is at least one
};

/// A name that ends in .xyz, or three numbers on the first line that is no comment.
bool LooksLikeCurve(const SourceText& text);

/// One curve or more, each of one point or more.
std::vector<CurveText> ParseCurves(const SourceText& text);

/// From where curves are seen; none: from the best of many views.
using CurveView = std::optional<algebra::Vector3>;
/// "X,Y,Z", from the rope toward the viewer, or "auto"; what names the option in messages.
CurveView ParseView(const std::string& text, const std::string& what);

/// Throws what() at the last point that the fault names; view is where it was looked from.
[[noreturn]] void FailAtFault(const SourceText& text, const CurveText& curve, const knot::CurveFault& fault,
                              const CurveView& view);

}  // namespace tact::input
