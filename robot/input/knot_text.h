/// @file
/// P-data from text, whatever its notation; its content says which one it is.
/// Model   {"sigma":[...],"attr":[...]}, with a "name" or not; the thesis' three rows on lines of their own or set apart by
///         '/', or the last two of them; a signed Gauss code (gauss_text.h); a PD code of an open rope (pd_text.h); the
///         points of a rope in space (curve_text.h), seen from above here, from wherever one wants in knot_sequence.h.
///         "/" alone is the straight rope.
/// Errors  InputError `source:line:column: expected this, got that`. P-data of a surface with handles are P-data: whether a
///         sphere holds them is asked by those who need one.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "algebra/knot/p_data.h"

namespace tact::input {

/// source names the text in messages; its first line is number first_line there.
knot::PData ParsePData(std::string_view text, const std::string& source, size_t first_line = 1);

/// Of a file ("-" is standard input), of an example of that name (knot_examples.h), or the text itself.
knot::PData ReadPData(const std::string& argument);

/// The same, refused with its genus if no sphere holds it.
knot::PData ReadPlanarPData(const std::string& argument);
/// "expected a diagram on a sphere, ..., got ...: genus 1"; nullopt: a sphere holds it.
std::optional<std::string> FindHandle(const knot::PData& p);

/// The text that ReadPData parses, and the name that its messages give it.
struct NamedText {
  std::string text, source;
};
NamedText FindKnotText(const std::string& argument);

}  // namespace tact::input
