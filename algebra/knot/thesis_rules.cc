#include "algebra/knot/thesis_rules.h"

#include <algorithm>
#include <cstdlib>

#include "algebra/knot/faces.h"

namespace tact::knot::thesis {
namespace {

// p without the columns, every other number less what `less` says of it.
template <typename Less>
PData Reordered(const PData& p, std::initializer_list<int> removed, Less less) {
  PDataBuilder rest(p.columns());
  for (int c = 1; c <= p.columns(); ++c) {
    if (std::find(removed.begin(), removed.end(), c) == removed.end())
      rest.Add(p.sigma(c) - less(p.sigma(c)), p.attr(c));
  }
  return rest.Take();
}

bool IsEndOf(int column, int segment) { return column == segment - 1 || column == segment; }

// Whether A is over both others and C under both.
bool AreNamedByHeight(const PData& p, const std::array<int, 3>& s) {
  return p.over(s[0] - 1) && p.over(s[0]) && p.over(s[1] - 1) != p.over(s[1]) && !p.over(s[2] - 1) &&
         !p.over(s[2]);
}

bool BoundAFace(const PData& p, const std::array<int, 3>& s) {
  std::array<int, 3> sorted = s;
  std::sort(sorted.begin(), sorted.end());
  for (const bool forward : {false, true}) {
    const Dart first{s[0], forward}, second = NextDart(p, first), third = NextDart(p, second);
    std::array<int, 3> walked = {first.segment, second.segment, third.segment};
    std::sort(walked.begin(), walked.end());
    if (NextDart(p, third) == first && walked == sorted) return true;
  }
  return false;
}

// The sign of the intersection of two of the segments.
int SignBetween(const PData& p, int segment, int other) {
  return p.sign(IsEndOf(p.sigma(segment - 1), other) ? segment - 1 : segment);
}

bool SignsAgree(const PData& a, const PData& b, int segment, int other) {
  return SignBetween(a, segment, other) == SignBetween(b, segment, other);
}

bool RestIsEqual(const PData& a, const PData& b, const std::array<int, 3>& s) {
  for (int c = 1; c <= a.columns(); ++c) {
    if (IsEndOf(c, s[0]) || IsEndOf(c, s[1]) || IsEndOf(c, s[2])) continue;
    if (a.sigma(c) != b.sigma(c) || a.attr(c) != b.attr(c)) return false;
  }
  return true;
}

}  // namespace

PData RemoveR1(const PData& p_t, int i) {
  return Reordered(p_t, {i, i + 1}, [i](int number) { return number >= i + 2 ? 2 : 0; });
}

PData RemoveR2(const PData& p_t, int i, int j) {
  return Reordered(p_t, {i, i + 1, j + 2, j + 3}, [i, j](int number) {
    return number >= j + 4 ? 4 : number >= i + 2 && number <= j + 1 ? 2 : 0;
  });
}

PData RemoveCrossAtSelectiveEnd(const PData& p_t) {
  const int i = p_t.sigma(1) - 1;
  return Reordered(p_t, {1, i + 1}, [i](int number) {
    return number >= i + 2 ? 2 : number >= 2 && number <= i ? 1 : 0;
  });
}

PData RemoveCrossAtOtherEnd(const PData& p_t) {
  const int n = p_t.columns(), j = p_t.sigma(n);
  return Reordered(p_t, {n, j}, [n, j](int number) { return number >= j + 1 && number <= n - 1 ? 1 : 0; });
}

std::vector<int> FindR1(const PData& p_before, const PData& p_t) {
  std::vector<int> found;
  if (p_t.columns() != p_before.columns() + 2) return found;
  for (int i = 1; i <= p_before.columns() + 1; ++i) {
    if (p_t.sigma(i) == i + 1 && RemoveR1(p_t, i) == p_before) found.push_back(i);
  }
  return found;
}

std::vector<std::pair<int, int>> FindR2(const PData& p_before, const PData& p_t, const R2Reading& reading) {
  std::vector<std::pair<int, int>> found;
  if (p_t.columns() != p_before.columns() + 4) return found;
  for (int i = 1; i <= p_before.columns() + 1; ++i) {
    for (int j = reading.equal_segments ? i : i + 1; j <= p_before.columns() + 1; ++j) {
      const int first = p_t.sigma(i), second = p_t.sigma(i + 1);
      if (!(first == j + 2 && second == j + 3) && !(first == j + 3 && second == j + 2)) continue;
      if (reading.same_height && reading.signs_differ && std::abs(p_t.attr(i) - p_t.attr(i + 1)) != 2)
        continue;
      if (reading.same_height && p_t.over(i) != p_t.over(i + 1)) continue;
      if (reading.signs_differ && p_t.sign(i) == p_t.sign(i + 1)) continue;
      if (RemoveR2(p_t, i, j) == p_before) found.emplace_back(i, j);
    }
  }
  return found;
}

std::optional<int> FindCrossAtSelectiveEnd(const PData& p_before, const PData& p_t) {
  if (p_t.columns() != p_before.columns() + 2 || RemoveCrossAtSelectiveEnd(p_t) != p_before)
    return std::nullopt;
  return p_t.sigma(1) - 1;
}

std::optional<int> FindCrossAtOtherEnd(const PData& p_before, const PData& p_t) {
  if (p_t.columns() != p_before.columns() + 2 || RemoveCrossAtOtherEnd(p_t) != p_before) return std::nullopt;
  return p_t.sigma(p_t.columns());
}

std::optional<char> TypeOf(const PData& p, const std::array<int, 3>& segments) {
  const auto [i, j, k] = segments;
  if (std::abs(i - j) < 2 || std::abs(j - k) < 2 || std::abs(k - i) < 2) return std::nullopt;  // six numbers
  const auto are = [&](int at_i1, int at_i, int j_column, int at_j) {
    return p.sigma(i - 1) == at_i1 && p.sigma(i) == at_i && p.sigma(j_column) == at_j;
  };
  if (are(j - 1, k - 1, j, k)) return 'A';
  if (are(j - 1, k, j, k - 1)) return 'B';
  if (are(j, k - 1, j - 1, k)) return 'C';
  if (are(j, k, j - 1, k - 1)) return 'D';
  if (are(k - 1, j - 1, j, k)) return 'E';
  if (are(k, j - 1, j, k - 1)) return 'F';
  if (are(k - 1, j, j - 1, k)) return 'G';
  if (are(k, j, j - 1, k - 1)) return 'H';
  return std::nullopt;
}

bool AcceptsR3(const PData& p_before, const PData& p_t, const std::array<int, 3>& segments,
               const R3Reading& reading) {
  const auto& s = segments;
  const int last = p_t.columns() - (reading.last_segment ? 0 : 1);
  if (p_t.columns() != p_before.columns() || std::max({s[0], s[1], s[2]}) > last) return false;
  const auto before = TypeOf(p_before, s), after = TypeOf(p_t, s);
  if (!before || !after || *after != PermittedType(*before)) return false;
  if (!AreNamedByHeight(p_before, s)) return false;
  if (reading.triangle != R3Triangle::kNamedBefore && !AreNamedByHeight(p_t, s)) return false;
  if (reading.triangle == R3Triangle::kFaces && !(BoundAFace(p_before, s) && BoundAFace(p_t, s)))
    return false;
  if (reading.same_signs &&
      !(SignsAgree(p_before, p_t, s[0], s[1]) && SignsAgree(p_before, p_t, s[0], s[2]) &&
        SignsAgree(p_before, p_t, s[1], s[2]))) {
    return false;
  }
  return RestIsEqual(p_before, p_t, s);
}

std::vector<R3Conclusion> FindR3(const PData& p_before, const PData& p_t, const R3Reading& reading) {
  std::vector<R3Conclusion> found;
  const int n = p_before.columns();
  if (p_t.columns() != n) return found;
  // The segments that meet A at its two ends: each of the two that share the column.
  for (int i = 2; i <= n; ++i) {
    for (const int b_column : {i - 1, i}) {
      const int b = p_before.sigma(b_column), c = p_before.sigma(b_column == i ? i - 1 : i);
      for (const int j : {b, b + 1}) {
        for (const int k : {c, c + 1}) {
          if (std::min(j, k) < 2 || std::max(j, k) > n) continue;
          if (AcceptsR3(p_before, p_t, {i, j, k}, reading))
            found.push_back({{i, j, k}, *TypeOf(p_before, {i, j, k})});
        }
      }
    }
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace tact::knot::thesis
