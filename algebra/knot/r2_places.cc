#include "algebra/knot/r2_places.h"

#include <algorithm>

namespace tact::knot {
namespace {

// Mates of the columns passed so far, by how much they grew, and whether an R2 can have made all of it.
struct PassedMates {
  explicit PassedMates(int n) : two_least(n + 1), four_least(n + 1) {}

  void Pass(int mate, int grown, bool same_attribute) {
    if (grown == 0) {
      kept_most = std::max(kept_most, mate);
    } else if (grown == 2) {
      two_least = std::min(two_least, mate);
      two_most = std::max(two_most, mate);
    } else if (grown == 4) {
      four_least = std::min(four_least, mate);
    } else {
      possible = false;
    }
    possible = possible && same_attribute;
  }

  bool possible = true;
  int kept_most = 0, two_least, two_most = 0, four_least;
};

}  // namespace

R2Places::R2Places(const PData& a, const PData& b) : cuts_(static_cast<size_t>(a.segments())) {
  const int n = a.columns();
  const auto cut = [this](int c) -> Cut& { return cuts_[static_cast<size_t>(c) - 1]; };

  PassedMates left(n);
  Cut sums;
  for (int c = 1; c <= n + 1; ++c) {
    cut(c) = sums;
    if (left.possible && left.kept_most < c && left.two_least >= c) {
      cut(c).j_low = std::max(c, left.two_most + 1);
      cut(c).j_high = left.four_least;
    }
    if (c > n) break;
    const int mate = a.sigma(c), grown = b.sigma(c) - mate;
    left.Pass(mate, grown, a.attr(c) == b.attr(c));
    sums.fours += grown == 4 ? 1 : 0;
    sums.crossing += mate > c ? 1 : -1;
    sums.attributes += a.attr(c) == b.attr(c + 2) ? 0 : 1;
    sums.not_twos += b.sigma(c + 2) == mate + 2 ? 0 : 1;
  }

  PassedMates right(n);
  for (int c = n + 1; c >= 1; --c) {
    if (right.possible && right.four_least >= c && right.two_most < c) {
      cut(c).i_low = right.kept_most + 1;
      cut(c).i_high = std::min(c, right.two_least);
    }
    if (c == 1) break;
    const int column = c - 1, mate = a.sigma(column);
    right.Pass(mate, b.sigma(column + 4) - mate, a.attr(column) == b.attr(column + 4));
  }
}

bool R2Places::EqualAt(int i, int j) const {
  const Cut &left = cuts_[static_cast<size_t>(i) - 1], &right = cuts_[static_cast<size_t>(j) - 1];
  if (j < left.j_low || j > left.j_high || i < right.i_low || i > right.i_high) return false;
  if (left.attributes != right.attributes) return false;
  const int mates_outside = left.crossing + right.crossing - 2 * left.fours;
  return right.not_twos - left.not_twos == mates_outside;
}

}  // namespace tact::knot
