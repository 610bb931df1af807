/// @file
/// Codes counted by what they are.
/// Model   p_data: a code of c intersections is that of 2^c P-data, one for each choice of over and under.
///         pairings: who crosses whom, crossing signs forgotten too. The classes of interlacing intersections (reducible.h) may be
///         mirrored each by itself: a planar pairing with k of them has 2^k codes, one of them with each class' first column of
///         turn +1; those are counted.
///         up to reversal, mirror, both: orbits, by the codes that the reversal, or the reversal of the mirror image, leaves as
///         they are (Burnside's lemma); no code but the straight rope's is its own mirror image.
/// Bound   Code::kMostCrossings; the counts fit 64 bits.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "enumerators/code_tree.h"

namespace tact::enumerators {

struct CodeCounts {
  uint64_t codes = 0;
  uint64_t pairings = 0;
  uint64_t irreducible = 0;
  uint64_t reversible = 0;         // equal to their reversal
  uint64_t mirror_reversible = 0;  // equal to their mirror image's reversal
  uint64_t ends_on_one_face = 0;

  CodeCounts& operator+=(const CodeCounts& other);
  friend bool operator==(const CodeCounts&, const CodeCounts&) = default;
};

uint64_t UpToReversal(const CodeCounts& counts);
uint64_t UpToMirror(const CodeCounts& counts);
uint64_t UpToBoth(const CodeCounts& counts);

/// Counts of the codes that grow from one, by their intersections: entry c is of those with c, up to `crossings`.
std::vector<CodeCounts> CountCodesFrom(const Code& code, int crossings);
/// Of all codes up to so many intersections; none if that is negative.
inline std::vector<CodeCounts> CountCodes(int crossings) {
  return crossings < 0 ? std::vector<CodeCounts>() : CountCodesFrom(Code(), crossings);
}

/// For the units of a run: "[[codes,pairings,...],...]", and back. InputError: anything else.
std::string ToText(const std::vector<CodeCounts>& counts);
std::vector<CodeCounts> ParseCodeCounts(std::string_view text);

}  // namespace tact::enumerators
