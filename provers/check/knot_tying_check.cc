// `knot-tying`: a knot tied from the straight rope by moves that are each checked at both of its P-data.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/knot_code.h"

namespace tact::check {
namespace {

enum class Kind { kR1, kR2, kR3, kCross };

struct Move {
  Kind kind = Kind::kR1;
  bool add = false;           // else it removes or shifts
  std::vector<int> segments;  // counted in the P-data with fewer intersections
  bool selective = false;     // of a Cross: which end
  int attr = 0;               // of the first new column, of a Cross of the end's column
  bool opposite = false;      // of an R2: the strands meet the two intersections in opposite order
};

std::size_t OneOf(const Value& value, std::initializer_list<std::string_view> words) {
  const std::string& word = AsString(value);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) throw Refused(&value, "not a word that may stand here");
  return static_cast<std::size_t>(found - words.begin());
}

void ExpectNull(const Value& value) {
  if (!std::holds_alternative<std::nullptr_t>(value.data)) throw Refused(&value, "expected null");
}

Move ReadMove(const Value& value) {
  ExpectKeys(value, {"kind", "direction", "segments", "end", "selective_end", "attr", "order"});
  Move move;
  move.kind = static_cast<Kind>(OneOf(At(value, "kind"), {"R1", "R2", "R3", "Cross"}));
  const Value& direction = At(value, "direction");
  const std::size_t way = OneOf(direction, {"remove", "add", "shift"});
  if ((way == 2) != (move.kind == Kind::kR3)) throw Refused(&direction, "an R3 shifts, nothing else does");
  move.add = way == 1;
  const Array& segments = AsArray(At(value, "segments"));
  const std::size_t count = move.kind == Kind::kR3 ? 3 : move.kind == Kind::kR2 ? 2 : 1;
  if (segments.size() != count) throw Refused(&At(value, "segments"), "not as many segments as the move has");
  for (const Value& segment : segments) move.segments.push_back(static_cast<int>(AsIndex(segment, 1u << 20)));
  const Value &end = At(value, "end"), &attr = At(value, "attr"), &order = At(value, "order");
  if (move.kind == Kind::kCross) {
    move.selective = OneOf(end, {"other", "selective"}) == 1;
  } else {
    ExpectNull(end);
  }
  OneOf(At(value, "selective_end"), {"same"});
  if (move.kind == Kind::kR3) {
    ExpectNull(attr);
  } else {
    move.attr = static_cast<int>(AsIndex(attr, 5));
    if (move.attr == 0) throw Refused(&attr, "an attribute is 1, 2, 3 or 4");
  }
  if (move.kind == Kind::kR2) {
    move.opposite = OneOf(order, {"same", "opposite"}) == 1;
  } else {
    ExpectNull(order);
  }
  return move;
}

struct Column {
  int column, mate, attr;
};

// over for under with one sign, and one sign for the other at one height.
int OtherHeight(int attr) { return attr % 2 == 1 ? attr + 1 : attr - 1; }
int OtherSign(int attr) { return attr > 2 ? attr - 2 : attr + 2; }

// The columns that the move adds to a P-data of n columns, of the one with more; R3 apart.
std::vector<Column> NewColumns(const Move& move, int n) {
  const int i = move.segments[0], a = move.attr, below = OtherHeight(a);
  if (move.kind == Kind::kR1) return {{i, i + 1, a}, {i + 1, i, below}};
  if (move.kind == Kind::kCross) {
    return move.selective ? std::vector<Column>{{1, i + 1, a}, {i + 1, 1, below}}
                          : std::vector<Column>{{i, n + 2, below}, {n + 2, i, a}};
  }
  const int j = move.segments[1];
  const int first = j + (move.opposite ? 3 : 2), second = j + (move.opposite ? 2 : 3);
  return {{i, first, a}, {i + 1, second, OtherSign(a)}, {first, i, below}, {second, i + 1, OtherSign(below)}};
}

void CheckAddition(const Value& where, const KnotCode& less, const KnotCode& more, const Move& move) {
  const int n = less.columns();
  for (const int segment : move.segments) {
    if (segment < 1 || segment > n + 1) throw Refused(&where, "no such segment");
  }
  if (move.kind == Kind::kR2 && move.segments[0] > move.segments[1])
    throw Refused(&where, "the lesser segment comes first");
  const std::vector<Column> added = NewColumns(move, n);
  if (more.columns() != n + static_cast<int>(added.size()))
    throw Refused(&where, "intersections come or go in another number");
  std::vector<bool> is_new(static_cast<std::size_t>(more.columns()) + 1, false);
  for (const Column& c : added) {
    if (more.mate(c.column) != c.mate || more.attribute(c.column) != c.attr)
      throw Refused(&where, "not the columns that the move adds or removes");
    is_new[static_cast<std::size_t>(c.column)] = true;
  }
  std::vector<int> old(is_new.size(), 0);  // numbers among the columns that are not new
  int count = 0;
  for (int i = 1; i <= more.columns(); ++i) {
    if (!is_new[static_cast<std::size_t>(i)]) old[static_cast<std::size_t>(i)] = ++count;
  }
  for (int i = 1; i <= more.columns(); ++i) {
    const int at = old[static_cast<std::size_t>(i)];
    if (at == 0) continue;
    if (less.mate(at) != old[static_cast<std::size_t>(more.mate(i))] ||
        less.attribute(at) != more.attribute(i))
      throw Refused(&where, "another column changes");
  }
}

// The sides of a face are three: one of each of these segments, of which none holds an end.
bool BoundAFace(const KnotCode& code, const std::vector<int>& segments) {
  const int n = code.columns();
  const std::vector<int> face = FacesOfCorners(code);
  const auto at = [&](int column, int q) { return face[static_cast<std::size_t>(4 * (column - 1) + q)]; };
  // The face on a segment's left (side 0) or right (side 1).
  const auto beside = [&](int s, int side) { return s <= n ? at(s, 2 + side) : at(n, side); };
  for (const int side : {0, 1}) {
    const int f = beside(segments[0], side);
    int sides = 0;
    std::array<int, 3> of{};
    for (int s = 1; s <= n + 1; ++s) {
      for (const int t : {0, 1}) {
        if (beside(s, t) != f) continue;
        ++sides;
        for (std::size_t k = 0; k < 3; ++k) of[k] += segments[k] == s ? 1 : 0;
      }
    }
    if (sides == 3 && of == std::array<int, 3>{1, 1, 1}) return true;
  }
  return false;
}

void CheckShift(const Value& where, const KnotCode& from, const KnotCode& to, const Move& move) {
  const int n = from.columns();
  if (to.columns() != n) throw Refused(&where, "an R3 keeps the number of intersections");
  std::vector<int> moved(static_cast<std::size_t>(n) + 1);
  for (int i = 0; i <= n; ++i) moved[static_cast<std::size_t>(i)] = i;
  for (std::size_t k = 0; k < 3; ++k) {
    const int s = move.segments[k];
    if (s < 2 || s > n) throw Refused(&where, "an R3 has no segment with an end");
    const bool over1 = from.over(s - 1), over2 = from.over(s);
    if (k == 1 ? over1 == over2 : over1 != over2 || over1 != (k == 0))
      throw Refused(&where, "the segments are not the one above, the middle one and the one below");
    std::swap(moved[static_cast<std::size_t>(s)], moved[static_cast<std::size_t>(s) - 1]);
  }
  if (!BoundAFace(from, move.segments)) throw Refused(&where, "the segments bound no face");
  for (int i = 1; i <= n; ++i) {
    const int source = moved[static_cast<std::size_t>(i)];
    if (to.mate(i) != moved[static_cast<std::size_t>(from.mate(source))] ||
        to.attribute(i) != from.attribute(source))
      throw Refused(&where, "the two ends of a segment do not change places");
  }
}

// (c + |u| + |v|) / 2: what no move changes by more than one (docs/certificates.md).
int LeastSteps(const KnotCode& code) {
  std::array<int, 2> signs{};
  for (int i = 1; i <= code.columns(); ++i) {
    if (code.mate(i) > i) signs[code.over(i) ? 0 : 1] += code.plus(i) ? 1 : -1;
  }
  return (code.columns() / 2 + std::abs(signs[0]) + std::abs(signs[1])) / 2;
}

}  // namespace

void CheckKnotTying(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"p_data", "moves"}, {"at_least"});
  const Array &texts = AsArray(At(certificate, "p_data")), &moves = AsArray(At(certificate, "moves"));
  if (texts.size() != moves.size() + 1) throw Refused(&certificate, "expected one P-data more than moves");
  std::vector<KnotCode> codes;
  for (const Value& text : texts) {
    codes.push_back(ReadKnotCode(text));
    if (!OnSphere(codes.back())) throw Refused(&text, "no sphere holds the diagram");
  }
  if (codes.front().columns() != 0) throw Refused(&texts.front(), "not the straight rope");
  for (std::size_t k = 0; k < moves.size(); ++k) {
    const Move move = ReadMove(moves[k]);
    const KnotCode &from = codes[k], &to = codes[k + 1];
    if (move.kind == Kind::kR3) {
      CheckShift(moves[k], from, to, move);
    } else {
      CheckAddition(moves[k], move.add ? from : to, move.add ? to : from, move);
    }
  }
  if (const Value* least = Find(certificate, "at_least")) {
    if (static_cast<int>(AsIndex(*least, std::size_t{1} << 20)) > LeastSteps(codes.back()))
      throw Refused(least, "fewer steps are not excluded by the signs of the intersections");
  }
}

}  // namespace tact::check
