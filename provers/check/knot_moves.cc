#include "provers/check/knot_moves.h"

#include <algorithm>

namespace tact::check {
namespace {

// How many corners a face has, and whether it has this one.
struct Corners {
  explicit Corners(const KnotCode& code) : face(FacesOfCorners(code)) {
    size.assign(face.size() + 1, 0);
    for (int i = 1; i <= code.columns(); ++i) {
      for (int q = 0; q < 4; ++q) size[At(Face(i, q))] += i < code.mate(i) ? 1 : 0;
    }
  }
  static std::size_t At(int i) { return static_cast<std::size_t>(i); }
  int Face(int column, int q) const { return face[At(4 * (column - 1) + q)]; }
  int SizeOf(int f) const { return size[At(f)]; }
  // The face on one side of an inner segment: q = 0 on the left, 1 on the right.
  int Beside(int segment, int q) const { return Face(segment - 1, q); }

  std::vector<int> face, size;
};

bool IsKink(const KnotCode& code, const Corners& corners, int i) {
  if (code.mate(i) != i + 1) return false;
  return corners.SizeOf(corners.Beside(i + 1, 0)) == 1 || corners.SizeOf(corners.Beside(i + 1, 1)) == 1;
}

// Segments from column a to a+1 and from column b to b+1 bound a face of two corners, and one is over the other.
bool IsLens(const KnotCode& code, const Corners& corners, int a, int b) {
  const int first = code.mate(a), second = code.mate(a + 1);
  if (std::min(first, second) != b || std::max(first, second) != b + 1 || b <= a + 1) return false;
  if (code.over(a) != code.over(a + 1)) return false;
  for (int p = 0; p < 2; ++p) {
    for (int q = 0; q < 2; ++q) {
      const int f = corners.Beside(a + 1, p);
      if (f == corners.Beside(b + 1, q) && corners.SizeOf(f) == 2) return true;
    }
  }
  return false;
}

bool IsTriangle(const KnotCode& code, const Corners& corners, const std::array<int, 3>& s) {
  std::vector<int> columns;
  for (const int segment : s) {
    if (segment < 2 || segment > code.columns()) return false;
    columns.push_back(segment - 1);
    columns.push_back(segment);
  }
  std::sort(columns.begin(), columns.end());
  if (std::adjacent_find(columns.begin(), columns.end()) != columns.end()) return false;
  for (const int c : columns) {
    if (!std::binary_search(columns.begin(), columns.end(), code.mate(c))) return false;
  }
  for (const int segment : s) {
    if (code.mate(segment) == segment - 1) return false;
  }
  for (int sides = 0; sides < 8; ++sides) {
    const int f = corners.Beside(s[0], sides & 1);
    if (corners.SizeOf(f) == 3 && corners.Beside(s[1], sides >> 1 & 1) == f &&
        corners.Beside(s[2], sides >> 2) == f)
      return true;
  }
  return false;
}

bool HasHeights(const KnotCode& code, const std::array<int, 3>& s) {
  return code.over(s[0] - 1) && code.over(s[0]) && code.over(s[1] - 1) != code.over(s[1]) &&
         !code.over(s[2] - 1) && !code.over(s[2]);
}

KnotCode Shifted(const KnotCode& code, const std::array<int, 3>& s) {
  std::vector<int> to(static_cast<std::size_t>(code.columns()) + 1);
  for (int i = 1; i <= code.columns(); ++i) to[static_cast<std::size_t>(i)] = i;
  for (const int segment : s)
    std::swap(to[static_cast<std::size_t>(segment)], to[static_cast<std::size_t>(segment) - 1]);
  KnotCode shifted = code;
  for (int i = 1; i <= code.columns(); ++i) {
    const auto at = static_cast<std::size_t>(to[static_cast<std::size_t>(i)]) - 1;
    shifted.sigma[at] = to[static_cast<std::size_t>(code.mate(i))];
    shifted.attr[at] = code.attribute(i);
  }
  return shifted;
}

void ExpectShift(const Value& where, const KnotCode& before, const KnotMove& move, const KnotCode& after) {
  if (!IsTriangle(before, Corners(before), move.segments))
    throw Refused(&where, "the segments bound no triangle");
  if (!HasHeights(before, move.segments))
    throw Refused(&where, "not over both, between and under both in this order");
  if (Shifted(before, move.segments) != after) throw Refused(&where, "leads to another code");
}

// The columns that the move takes out of `larger`, ascending; refuses what is no kink, lens or end.
std::vector<int> TakenColumns(const Value& where, const KnotCode& larger, const KnotMove& move) {
  const int n = larger.columns(), i = move.segments[0], j = move.segments[1];
  if (move.kind == "R1") {
    if (n < 2 || i > n - 1 || !IsKink(larger, Corners(larger), i)) throw Refused(&where, "no kink is there");
    return {i, i + 1};
  }
  if (move.kind == "R2") {
    if (i > j) throw Refused(&where, "the lesser segment comes first");
    if (n < 4 || j > n - 3 || !IsLens(larger, Corners(larger), i, j + 2))
      throw Refused(&where, "no lens is there");
    if ((larger.mate(i) > larger.mate(i + 1)) != move.opposite)
      throw Refused(&where, "the order is the other one");
    return {i, i + 1, j + 2, j + 3};
  }
  if (n < 2) throw Refused(&where, "there is no intersection");
  const int end = move.selective ? 1 : n, crossed = move.selective ? i + 1 : i;
  if (larger.mate(end) != crossed) throw Refused(&where, "the end crosses another segment");
  return {std::min(end, crossed), std::max(end, crossed)};
}

}  // namespace

KnotMove ReadKnotMove(const Value& value) {
  ExpectKeys(value, {"kind", "direction", "segments", "end", "selective_end", "attr", "order"});
  // Whether the member is the first of the words; refuses what is none of them.
  const auto choice = [&](const char* key, const char* yes, const char* no) {
    const std::string& text = AsString(At(value, key));
    if (text != yes && text != no)
      throw Refused(&At(value, key), std::string("expected ") + yes + " or " + no);
    return text == yes;
  };
  const auto expect_null = [&](const char* key) {
    if (!std::holds_alternative<std::nullptr_t>(At(value, key).data))
      throw Refused(&At(value, key), "expected null for this kind of move");
  };
  KnotMove move;
  move.kind = AsString(At(value, "kind"));
  move.direction = AsString(At(value, "direction"));
  const bool shift = move.kind == "R3", lens = move.kind == "R2", cross = move.kind == "Cross";
  if (!shift && !lens && !cross && move.kind != "R1")
    throw Refused(&At(value, "kind"), "expected R1, R2, R3 or Cross");
  if (shift ? move.direction != "shift" : move.direction != "add" && move.direction != "remove")
    throw Refused(&At(value, "direction"), "expected " + std::string(shift ? "shift" : "add or remove"));
  choice("selective_end", "same", "same");
  const Array& segments = AsArray(At(value, "segments"));
  if (segments.size() != (shift ? 3u : lens ? 2u : 1u))
    throw Refused(&At(value, "segments"), "not as many segments as the move has");
  for (std::size_t k = 0; k < segments.size(); ++k) {
    move.segments[k] = static_cast<int>(AsIndex(segments[k], std::size_t{1} << 20));
    if (move.segments[k] == 0) throw Refused(&segments[k], "segments count from 1");
  }
  if (shift) {
    expect_null("attr");
  } else {
    move.attr = static_cast<int>(AsIndex(At(value, "attr"), 5));
  }
  if (lens) {
    move.opposite = choice("order", "opposite", "same");
  } else {
    expect_null("order");
  }
  if (cross) {
    move.selective = choice("end", "selective", "other");
  } else {
    expect_null("end");
  }
  return move;
}

void ExpectMoveLeads(const Value& where, const KnotCode& before, const KnotMove& move,
                     const KnotCode& after) {
  if (move.kind == "R3") return ExpectShift(where, before, move, after);
  const KnotCode& larger = move.direction == "add" ? after : before;
  const std::vector<int> taken = TakenColumns(where, larger, move);
  const int first = move.kind == "Cross" && !move.selective ? larger.columns() : taken[0];
  if (larger.attribute(first) != move.attr) throw Refused(&where, "the attribute is another one");
  if (WithoutColumns(larger, taken) != (move.direction == "add" ? before : after))
    throw Refused(&where, "leads to another code");
}

bool AnyLensLeads(const KnotCode& larger, const KnotCode& smaller) {
  if (larger.columns() != smaller.columns() + 4) return false;
  const Corners corners(larger);
  for (int a = 1; a < larger.columns(); ++a) {
    const int b = std::min(larger.mate(a), larger.mate(a + 1));
    if (b > a + 1 && b < larger.columns() && IsLens(larger, corners, a, b) &&
        WithoutColumns(larger, {a, a + 1, b, b + 1}) == smaller)
      return true;
  }
  return false;
}

bool AnyTriangleLeads(const KnotCode& before, const KnotCode& after) {
  if (before.columns() != after.columns()) return false;
  const Corners corners(before);
  const int n = before.columns();
  for (int a = 2; a <= n; ++a) {
    // The others meet the first at its ends, so only these four by four need be tried.
    for (const int b : {before.mate(a - 1), before.mate(a - 1) + 1, before.mate(a), before.mate(a) + 1}) {
      for (const int c : {before.mate(a - 1), before.mate(a - 1) + 1, before.mate(a), before.mate(a) + 1}) {
        const std::array<int, 3> s = {a, b, c};
        if (IsTriangle(before, corners, s) && HasHeights(before, s) && Shifted(before, s) == after)
          return true;
      }
    }
  }
  return false;
}

bool BoundsTriangle(const KnotCode& code, const std::array<int, 3>& segments) {
  return IsTriangle(code, Corners(code), segments);
}

KnotCode WithoutColumns(const KnotCode& code, const std::vector<int>& columns) {
  const auto below = [&](int column) {
    return static_cast<int>(std::lower_bound(columns.begin(), columns.end(), column) - columns.begin());
  };
  KnotCode rest;
  for (int i = 1; i <= code.columns(); ++i) {
    if (std::binary_search(columns.begin(), columns.end(), i)) continue;
    rest.sigma.push_back(code.mate(i) - below(code.mate(i)));
    rest.attr.push_back(code.attribute(i));
  }
  return rest;
}

}  // namespace tact::check
