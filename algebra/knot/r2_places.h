/// @file
/// At which places two strands of one P-data may have been laid over each other to give another: each answer in constant time.
/// Model   b has four columns more than a: i, i+1 and j+2, j+3. What is left of i, between, and right of j keeps its number, or
///         gets two or four more. Left of i, a column's mate tells by how much its number grew on which side of i and j the mate
///         is: bounds for j that only narrow as i grows. The same from the right. What is left are pairs within the middle: as
///         many columns there must grow by two as have their mates there, which counts of prefixes tell.
/// Cost    O(n) once; then O(1) a place.
#pragma once

#include <vector>

#include "algebra/knot/p_data.h"

namespace tact::knot {

class R2Places {
 public:
  /// Precondition: b has four columns more than a.
  R2Places(const PData& a, const PData& b);

  /// Whether b without columns i, i+1, j+2, j+3 is a. Precondition: 1 <= i <= j <= n + 1, and these columns of b are mates of
  /// each other.
  bool EqualAt(int i, int j) const;

 private:
  // Between columns c - 1 and c of a.
  struct Cut {
    int j_low = 1, j_high = 0;  // what the columns before leave for j if i = c
    int i_low = 1, i_high = 0;  // what the columns from c on leave for i if j = c
    int fours = 0;              // columns before whose mates' numbers grow by four
    int crossing = 0;           // pairs with one column before
    int attributes = 0;         // columns before that differ in attribute when moved by two
    int not_twos = 0;           // columns before that, moved by two, do not have a mate moved by two
  };
  std::vector<Cut> cuts_;  // cut c at [c - 1], c from 1 to n + 1
};

}  // namespace tact::knot
