/// @file
/// P-data: the code of an open rope's diagram, read off from its selective end [thesis, 5.1.2].
/// Model   Following the rope from its selective end, number the intersections as they are met: each gets two numbers,
///         the columns 1..n of P-data. sigma(i) is the other number of column i's intersection; attr(i) says whether the
///         strand that is followed is the upper one there, and the intersection's sign. Segment i is the strand between
///         columns i-1 and i; segments 1 and n+1 hold the ends. A straight rope has no column and one segment.
/// Shapes  n = columns() is twice crossings(). Columns and segments are counted from 1 at every name in this folder.
/// Sign    of an intersection: that of (l_over x l_under) . e_z, e_z toward the viewer; + is knot theory's positive
///         crossing. Reversing the rope keeps it. Attributes: 1 over/-, 2 under/-, 3 over/+, 4 under/+.
/// Turn    turn(i) = sign of (l_i x l_sigma(i)) . e_z, +1 if the other strand passes from right to left: attr(i)'s sign for
///         the upper strand, the opposite for the lower. It alone decides the shape of the diagram's faces.
/// Errors  PreconditionError: rows that are no P-data; FindFault says why. Whether a sphere holds the diagram is another
///         question: faces.h.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tact::knot {

/// Why two rows are no P-data.
struct PDataFault {
  int column = 0;    // the first column that is wrong, from 1; 0: the rows as a whole
  std::string what;  // "expected ..., got ..."
};

class PData {
 public:
  /// The straight rope.
  PData() = default;
  /// The second and third row of the thesis' notation. PreconditionError: FindFault finds one.
  PData(const std::vector<int>& sigma, const std::vector<int>& attr);

  /// What keeps the rows from being P-data: lengths that differ or are odd, a sigma that is no involution or has a fixed
  /// column, an attribute out of 1..4, an intersection with two upper strands or two signs. O(n).
  static std::optional<PDataFault> FindFault(const std::vector<int>& sigma, const std::vector<int>& attr);

  int columns() const { return static_cast<int>(columns_.size()); }
  int crossings() const { return columns() / 2; }
  int segments() const { return columns() + 1; }

  int sigma(int column) const { return static_cast<int>(At(column) >> 2); }
  int attr(int column) const { return static_cast<int>(At(column) & 3) + 1; }
  bool over(int column) const { return (At(column) & 1) == 0; }
  int sign(int column) const { return (At(column) & 2) != 0 ? 1 : -1; }
  int turn(int column) const { return over(column) ? sign(column) : -sign(column); }

  /// The rows of the thesis' notation.
  std::vector<int> SigmaRow() const;
  std::vector<int> AttrRow() const;
  /// {"sigma":[4,5,6,1,2,3],"attr":[3,1,2,4,2,1]}
  std::string ToJson() const;

  friend bool operator==(const PData&, const PData&) = default;
  /// Fewer columns first, then column by column: mates, then attributes.
  friend std::strong_ordering operator<=>(const PData& a, const PData& b);

 private:
  friend class PDataBuilder;
  uint32_t At(int column) const { return columns_[static_cast<size_t>(column) - 1]; }

  std::vector<uint32_t> columns_;  // mate << 2 | attribute - 1
};

/// Columns put one after another, without a check: for code that makes P-data from P-data.
class PDataBuilder {
 public:
  explicit PDataBuilder(int columns) { p_.columns_.reserve(static_cast<size_t>(columns)); }
  void Add(int sigma, int attr) {
    p_.columns_.push_back(static_cast<uint32_t>(sigma) << 2 | static_cast<uint32_t>(attr - 1));
  }
  PData Take() { return std::move(p_); }

 private:
  PData p_;
};

/// attr of the same intersection on its other strand: over for under, the sign kept.
inline int MateAttribute(int attr) { return ((attr - 1) ^ 1) + 1; }
/// The attribute with that height and that turn.
inline int AttributeOf(bool over, int turn) {
  const bool plus = over ? turn > 0 : turn < 0;
  return 1 + (over ? 0 : 1) + (plus ? 2 : 0);
}

/// The equivalent P-data: read off from the other end [thesis, Propositions 14 and 15]. Its own inverse.
PData EquivalentPData(const PData& p);
/// Seen in a mirror that stands on the table: the shape is mirrored, heights stay; every sign changes.
PData MirrorShape(const PData& p);
/// Seen in the table as a mirror: the shape stays, over and under change places; every sign changes.
PData MirrorHeights(const PData& p);
/// The lesser of p and its equivalent P-data: the same for both choices of the selective end.
PData CanonicalPData(const PData& p);

}  // namespace tact::knot
