#include "enumerators/code_transfer.h"

#include <array>
#include <string>
#include <unordered_map>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

constexpr int kMostStrands = 64;

// Strands that dangle, in cycles round their holes; strand 0 is the tip. A strand that is taken away leaves a gap in the numbers.
class State {
 public:
  State() : count_(1) { next_[0] = previous_[0] = partner_[0] = 0; }
  explicit State(const std::string& key);

  int tip() const { return tip_; }
  int Next(int strand) const { return next_[At(strand)]; }
  // How many strands dangle into the tip's hole.
  int TipHole() const {
    int size = 1;
    for (int s = Next(tip_); s != tip_; s = Next(s)) ++size;
    return size;
  }

  // The tip meets a strand of which nothing is known.
  void CrossNew() {
    const int left = count_++, right = count_++;
    partner_[At(left)] = Byte(right);
    partner_[At(right)] = Byte(left);
    Link(previous_[At(tip_)], left);
    Link(right, next_[At(tip_)] == tip_ ? left : next_[At(tip_)]);
    Link(left, tip_);
    Link(tip_, right);
  }

  // The tip is the strand that dangles into its hole; it goes on at that one's partner.
  void CloseWith(int strand) {
    const int after_tip = next_[At(tip_)], before_tip = previous_[At(tip_)];
    const int after = next_[At(strand)], before = previous_[At(strand)];
    if (after_tip != strand) Link(before, after_tip);
    if (after != tip_) Link(before_tip, after);
    tip_ = partner_[At(strand)];
    partner_[At(tip_)] = Byte(tip_);
    strands_closed_ += 2;
  }

  // The lesser text of the two mirror images; empty if a hole is out of the tip's reach.
  std::string Key() const {
    const std::string forward = Walk(next_), backward = Walk(previous_);
    return forward < backward ? forward : backward;
  }

 private:
  using Links = std::array<int8_t, kMostStrands>;
  static size_t At(int strand) { return static_cast<size_t>(strand); }
  static int8_t Byte(int number) { return static_cast<int8_t>(number); }
  void Link(int a, int b) {
    next_[At(a)] = Byte(b);
    previous_[At(b)] = Byte(a);
  }

  // Numbers the strands as a walk from the tip meets them: round its hole, then round the hole of the first strand's partner that
  // was not met, and so on. A strand met is written as its partner's number, or kNew if that was not met; kHole ends a hole.
  static constexpr char kHole = 0, kNew = 1, kFirst = 2;
  std::string Walk(const Links& onward) const {
    std::array<int8_t, kMostStrands> met;
    Links number;
    number.fill(-1);
    int count = 0;
    std::string text;
    for (int from = tip_, seen = 0;;) {
      int s = from;
      do {
        number[At(s)] = Byte(count);
        met[At(count++)] = Byte(s);
        const int partner = number[At(partner_[At(s)])];
        if (s != tip_) text += partner < 0 ? kNew : static_cast<char>(kFirst + partner);
        s = onward[At(s)];
      } while (s != from);
      text += kHole;
      while (seen < count && number[At(partner_[At(met[At(seen)])])] >= 0) ++seen;
      if (seen == count) break;
      from = partner_[At(met[At(seen)])];
    }
    return count == count_ - strands_closed_ ? text : std::string();
  }

  int count_ = 0, strands_closed_ = 0;
  int tip_ = 0;
  Links next_, previous_, partner_;
};

State::State(const std::string& key) {
  int first = 0;
  partner_[At(count_++)] = 0;
  for (const char c : key) {
    if (c == kHole) {
      for (int s = first; s < count_; ++s) Link(s, s + 1 < count_ ? s + 1 : first);
      first = count_;
      continue;
    }
    const int strand = count_++;
    if (c == kNew) continue;
    const int partner = c - kFirst;
    partner_[At(strand)] = Byte(partner);
    partner_[At(partner)] = Byte(strand);
  }
}

using Layer = std::unordered_map<std::string, uint64_t>;

void Add(uint64_t& sum, uint64_t more) {
  if (__builtin_add_overflow(sum, more, &sum)) throw InvariantError("a count of codes does not fit 64 bits");
}

void Keep(Layer& layer, const State& state, uint64_t ways) {
  const std::string key = state.Key();
  if (!key.empty()) Add(layer[key], ways);
}

int Strands(const std::string& key) {
  int count = 1;
  for (const char c : key) count += c != 0 ? 1 : 0;
  return count;
}

}  // namespace

std::vector<uint64_t> CountCodesByTransfer(int crossings,
                                           const std::function<void(const TransferProgress&)>& progress) {
  std::vector<uint64_t> codes(static_cast<size_t>(crossings) + 1, 0);
  Layer layer = {{State().Key(), 1}};
  for (int step = 0; !layer.empty(); ++step) {
    if (progress) progress({step, 2 * crossings + 1, layer.size()});
    Layer next;
    for (const auto& [key, ways] : layer) {
      const int strands = Strands(key);
      // A new intersection brings two strands, a closing takes two.
      const int met = (strands - 1 + 2 * step) / 4;
      if (strands == 1) Add(codes[static_cast<size_t>(met)], ways);
      const State state(key);
      if (met < crossings) {
        State crossed = state;
        crossed.CrossNew();
        Keep(next, crossed, ways);
      }
      const bool even = state.TipHole() % 2 == 0;
      int between = 0;
      for (int s = state.Next(state.tip()); s != state.tip(); s = state.Next(s), ++between) {
        if (even && between % 2 == 1) continue;  // would leave two more odd holes
        State closed = state;
        closed.CloseWith(s);
        Keep(next, closed, ways);
      }
    }
    layer = std::move(next);
  }
  return codes;
}

}  // namespace tact::enumerators
