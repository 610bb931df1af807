#include "algebra/knot/bracket.h"

#include <numeric>
#include <vector>

#include "algebra/error.h"

namespace tact::knot {
namespace {

constexpr int kMostCrossings = 24;

// Loops of a state, its arc apart: classes of segments that are joined, less one.
class LoopCounter {
 public:
  explicit LoopCounter(const PData& p) : parent_(static_cast<size_t>(p.segments()) + 1) {
    for (int i = 1; i <= p.columns(); ++i) {
      if (p.sigma(i) > i) crossings_.push_back({i, p.sigma(i)});
    }
  }

  int Count(uint32_t along) {
    std::iota(parent_.begin(), parent_.end(), 0);
    int classes = static_cast<int>(parent_.size()) - 1;
    for (size_t k = 0; k < crossings_.size(); ++k) {
      const auto [i, j] = crossings_[k];
      const bool oriented = (along >> k & 1) != 0;
      classes -= Join(i, oriented ? j + 1 : j);
      classes -= Join(i + 1, oriented ? j : j + 1);
    }
    return classes - 1;
  }

 private:
  int Root(int a) {
    while (parent_[static_cast<size_t>(a)] != a) {
      int& up = parent_[static_cast<size_t>(a)];
      up = parent_[static_cast<size_t>(up)];
      a = up;
    }
    return a;
  }
  int Join(int a, int b) {
    a = Root(a);
    b = Root(b);
    parent_[static_cast<size_t>(a)] = b;
    return a == b ? 0 : 1;
  }

  std::vector<std::pair<int, int>> crossings_;
  std::vector<int> parent_;
};

void AddTo(BracketPolynomial& sum, int exponent, int64_t coefficient) {
  int64_t& at = sum[exponent];
  at += coefficient;
  if (at == 0) sum.erase(exponent);
}

}  // namespace

BracketPolynomial NormalizedBracket(const PData& p) {
  if (p.crossings() > kMostCrossings) throw PreconditionError("NormalizedBracket: too many intersections");
  std::vector<int> signs;
  int writhe = 0;
  for (int i = 1; i <= p.columns(); ++i) {
    if (p.sigma(i) > i) signs.push_back(p.sign(i));
  }
  for (const int s : signs) writhe += s;
  // How many states have so many loops and that power of A.
  std::map<std::pair<int, int>, int64_t> states;
  LoopCounter loops(p);
  for (uint32_t along = 0; along < 1u << signs.size(); ++along) {
    int power = 0;
    for (size_t k = 0; k < signs.size(); ++k) power += (along >> k & 1) != 0 ? signs[k] : -signs[k];
    ++states[{loops.Count(along), power}];
  }
  BracketPolynomial sum;
  for (const auto& [state, count] : states) {
    const auto [loop_count, power] = state;
    int64_t binomial = 1;  // (-1)^loops (A^2 + A^-2)^loops, term by term
    for (int k = 0; k <= loop_count; ++k) {
      AddTo(sum, power - 3 * writhe + 4 * k - 2 * loop_count,
            count * binomial * ((loop_count + writhe) % 2 == 0 ? 1 : -1));
      binomial = binomial * (loop_count - k) / (k + 1);
    }
  }
  return sum;
}

}  // namespace tact::knot
