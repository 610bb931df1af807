/// @file
/// All codes of a sphere with so many intersections, each once, without storing them.
/// Model   A code is planar P-data with over and under forgotten: who crosses whom, and which way. Every code is grown from the
///         straight rope in exactly one way: its tip crosses one dart of the face that it lies in, again and again (undone by
///         taking away the last column and its mate, a Cross move of the other end).
/// Order   canonical: depth first, a code before what grows from it, children in the order of the walk round the tip's face
///         with the face on the left, from the tip's own segment backward.
/// Shapes  columns are counted from 1, as in p_data.h; entry 0 of the rows is not used.
/// Cost    O(n) a code, some 20 ns; nothing is allocated.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

namespace tact::enumerators {

struct Code {
  static constexpr int kMostCrossings = 15;
  static constexpr size_t kRow = 2 * kMostCrossings + 2;  // columns from 1 and one to spare
  using Row = std::array<int8_t, 2 * kRow>;               // beyond kRow: room for Cross, of no meaning

  int columns = 0;
  Row sigma{};  // the column's mate
  Row turn{};   // +1 if the other strand passes from right to left, -1 otherwise (p_data.h)

  int crossings() const { return columns / 2; }
};

/// A side of a segment, as a direction along it with the side on the left.
struct CodeDart {
  int8_t segment;
  bool forward;

  friend bool operator==(const CodeDart&, const CodeDart&) = default;
};

/// knot::NextDart for codes.
inline CodeDart NextDart(const Code& code, CodeDart d) {
  const auto met = static_cast<size_t>(d.forward ? d.segment : d.segment - 1);
  if (met == 0 || met > static_cast<size_t>(code.columns)) return {d.segment, !d.forward};
  const bool forward = (code.turn[met] > 0) == d.forward;
  return {static_cast<int8_t>(code.sigma[met] + (forward ? 1 : 0)), forward};
}

/// The walk round the face that the tip lies in, from the tip's own segment backward.
struct TipFace {
  int size = 0;
  std::array<CodeDart, 4 * Code::kMostCrossings + 2> darts;
};
inline TipFace TipFaceOf(const Code& code) {
  TipFace face;
  const CodeDart tip{static_cast<int8_t>(code.columns + 1), false};
  CodeDart d = tip;
  do {
    face.darts[static_cast<size_t>(face.size++)] = d;
    d = NextDart(code, d);
  } while (d != tip);
  return face;
}

/// The code whose tip has crossed the dart. Rows are copied whole, behind the new column once more and one further: a fixed number
/// of bytes, which compilers make vectors of.
inline void Cross(const Code& code, CodeDart d, Code& grown) {
  const auto at = static_cast<size_t>(d.segment);
  Code::Row mates;
  for (size_t i = 0; i < Code::kRow; ++i) {
    mates[i] = static_cast<int8_t>(code.sigma[i] + (code.sigma[i] >= d.segment ? 1 : 0));
  }
  std::memcpy(grown.sigma.data(), mates.data(), Code::kRow);
  std::memcpy(grown.sigma.data() + at + 1, mates.data() + at, Code::kRow);
  std::memcpy(grown.turn.data(), code.turn.data(), Code::kRow);
  std::memcpy(grown.turn.data() + at + 1, code.turn.data() + at, Code::kRow);
  grown.columns = code.columns + 2;
  const auto last = static_cast<size_t>(grown.columns);
  grown.sigma[at] = static_cast<int8_t>(last);
  grown.sigma[last] = d.segment;
  grown.turn[at] = d.forward ? -1 : 1;  // the tip leaves the dart's left side
  grown.turn[last] = d.forward ? 1 : -1;
}

/// Visits each code that grows from `code` with exactly that many intersections, itself if it has them.
template <typename Visit>
void ForEachCodeFrom(const Code& code, int crossings, const Visit& visit) {
  if (code.crossings() == crossings) return visit(code);
  const TipFace face = TipFaceOf(code);
  Code grown;
  for (int i = 0; i < face.size; ++i) {
    Cross(code, face.darts[static_cast<size_t>(i)], grown);
    ForEachCodeFrom(grown, crossings, visit);
  }
}

/// Visits each code with exactly that many intersections, at most Code::kMostCrossings, in canonical order.
template <typename Visit>
void ForEachCode(int crossings, const Visit& visit) {
  ForEachCodeFrom(Code(), crossings, visit);
}

}  // namespace tact::enumerators
