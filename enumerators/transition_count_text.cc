#include <charconv>
#include <limits>

#include "algebra/error.h"
#include "enumerators/transition_count.h"

namespace tact::enumerators {
namespace {

using algebra::Rational;
using algebra::Vector3;

constexpr int64_t kVersion = 1;

int64_t Small(const algebra::Integer& value) {
  if (!value.is_small())
    throw PreconditionError("a transition's place has numbers of 64 bits, got " + value.ToString());
  return value.small();
}

class Writer {
 public:
  void Add(int64_t value) { text_ += (text_.empty() ? "[" : ",") + std::to_string(value); }
  void AddCount(uint64_t value) { Add(static_cast<int64_t>(value)); }
  void Add(const Rational& value) {
    Add(Small(value.numerator()));
    Add(Small(value.denominator()));
  }
  void Add(const Vector3& v) { Add(v.x), Add(v.y), Add(v.z); }
  std::string Take() { return text_ + "]"; }

 private:
  std::string text_;
};

class Reader {
 public:
  explicit Reader(const std::string& text) {
    const char *at = text.data(), *end = at + text.size();
    if (text.size() < 2 || text.front() != '[' || text.back() != ']') Refuse("no array");
    while (at + 1 < end) {
      int64_t value = 0;
      const auto [next, error] = std::from_chars(at + 1, end, value);
      if (error != std::errc() || (*next != ',' && *next != ']')) Refuse("no integer");
      numbers_.push_back(value);
      at = next;
    }
  }

  int64_t Next() {
    if (next_ == numbers_.size()) Refuse("too few integers");
    return numbers_[next_++];
  }
  int NextSmall() {
    const int64_t value = Next();
    if (value < 0 || value > std::numeric_limits<int>::max()) Refuse("a number out of range");
    return static_cast<int>(value);
  }
  uint64_t NextCount() {
    const int64_t value = Next();
    if (value < 0) Refuse("a negative count");
    return static_cast<uint64_t>(value);
  }
  Rational NextRational() {
    const int64_t numerator = Next(), denominator = Next();
    if (denominator <= 0) Refuse("a denominator that is not positive");
    return {algebra::Integer(static_cast<long long>(numerator)),
            algebra::Integer(static_cast<long long>(denominator))};
  }
  Vector3 NextVector() {
    Vector3 v;
    for (int i = 0; i < 3; ++i) v[i] = NextRational();
    return v;
  }
  void Finish() const {
    if (next_ != numbers_.size()) Refuse("too many integers");
  }

  [[noreturn]] static void Refuse(const std::string& what) {
    throw PreconditionError("not the text of a transition count: " + what);
  }

 private:
  std::vector<int64_t> numbers_;
  size_t next_ = 0;
};

}  // namespace

std::string ToText(const TransitionCount& count) {
  Writer out;
  out.Add(kVersion);
  for (const uint64_t value :
       {count.pairs, count.cells, count.formations, count.uneven_formations, count.borders, count.tilts,
        count.undecided_tilts, uint64_t{count.tallies.size()}})
    out.AddCount(value);
  for (const auto& [key, tally] : count.tallies) {
    for (const int value : {static_cast<int>(key.measure), key.lost_dimensions, key.opens ? 1 : 0, key.motion,
                            key.from, key.to})
      out.Add(int64_t{value});
    out.AddCount(tally.count);
    out.AddCount(tally.first.unit);
    out.Add(tally.first.border);
    out.Add(tally.first.open);
    out.Add(int64_t{tally.first.turn ? 1 : 0});
    if (!tally.first.turn) continue;
    out.Add(tally.first.turn->center);
    out.Add(int64_t{tally.first.turn->axis});
    out.Add(tally.first.turn->tangent);
  }
  return out.Take();
}

TransitionCount FromText(const std::string& text) {
  Reader in(text);
  if (in.Next() != kVersion) Reader::Refuse("another version");
  TransitionCount count;
  for (uint64_t* value : {&count.pairs, &count.cells, &count.formations, &count.uneven_formations,
                          &count.borders, &count.tilts, &count.undecided_tilts})
    *value = in.NextCount();
  const uint64_t tallies = in.NextCount();
  for (uint64_t i = 0; i < tallies; ++i) {
    TallyKey key;
    const int measure = in.NextSmall();
    if (measure > static_cast<int>(Measure::kLawBroken)) Reader::Refuse("an unknown measure");
    key.measure = static_cast<Measure>(measure);
    key.lost_dimensions = in.NextSmall();
    key.opens = in.NextSmall() != 0;
    for (int* value : {&key.motion, &key.from, &key.to}) *value = in.NextSmall();
    Tally tally;
    tally.count = in.NextCount();
    tally.first.unit = in.NextCount();
    tally.first.border = in.NextVector();
    tally.first.open = in.NextVector();
    if (in.NextSmall() != 0) {
      const Vector3 center = in.NextVector();
      const int axis = in.NextSmall();
      if (axis > 2) Reader::Refuse("an unknown axis");
      tally.first.turn = Turn{center, axis, in.NextRational()};
    }
    if (!count.tallies.emplace(key, tally).second) Reader::Refuse("a tally twice");
  }
  in.Finish();
  return count;
}

}  // namespace tact::enumerators
