// The thesis' rules that read an R2 or an R3 off two codes, literally, and pairs of codes on which they fail [thesis, 5.3.2, 5.3.3].
#include <algorithm>
#include <cstdlib>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/knot_moves.h"

namespace tact::check {
namespace {

// Which conditions a rule asks for; see docs/certificates.md.
struct Reading {
  bool same_height = false, signs_differ = false;                       // R2
  bool named_at_both_times = false, faces = false, signs_kept = false;  // R3
  bool whole_range = false;                                             // both: i = j, the segment n
};

Reading ReadReading(const Value& rule, const std::string& kind) {
  Reading reading;
  const auto flag = [&](const char* key) { return AsBool(At(rule, key)); };
  if (kind == "R2") {
    ExpectKeys(rule, {"kind", "same_height", "signs_differ", "whole_range"});
    reading.same_height = flag("same_height");
    reading.signs_differ = flag("signs_differ");
  } else if (kind == "R3") {
    ExpectKeys(rule, {"kind", "named_at_both_times", "faces", "signs_kept", "whole_range"});
    reading.named_at_both_times = flag("named_at_both_times");
    reading.faces = flag("faces");
    reading.signs_kept = flag("signs_kept");
  } else {
    throw Refused(&At(rule, "kind"), "expected R2 or R3");
  }
  reading.whole_range = flag("whole_range");
  return reading;
}

bool RuleAcceptsR2(const KnotCode& before, const KnotCode& after, const Reading& reading, int i, int j) {
  const int most = before.columns() + 1;
  if (after.columns() != before.columns() + 4 || i < 1 || j > most || i > j ||
      (i == j && !reading.whole_range))
    return false;
  const int first = after.mate(i), second = after.mate(i + 1);
  if (!(first == j + 2 && second == j + 3) && !(first == j + 3 && second == j + 2)) return false;
  if (reading.same_height && after.over(i) != after.over(i + 1)) return false;
  if (reading.signs_differ && after.plus(i) == after.plus(i + 1)) return false;
  return WithoutColumns(after, {i, i + 1, j + 2, j + 3}) == before;
}

// sigma(i-1), sigma(i) and the mate of j-1 or j, as the types A to H list them; '-' if the segments do not meet so.
char TypeOf(const KnotCode& code, int i, int j, int k) {
  if (std::abs(i - j) < 2 || std::abs(j - k) < 2 || std::abs(k - i) < 2) return '-';  // they have six columns
  const int a = code.mate(i - 1), b = code.mate(i);
  const auto third = [&](int column, int mate) { return code.mate(column) == mate; };
  if (a == j - 1 && b == k - 1 && third(j, k)) return 'A';
  if (a == j - 1 && b == k && third(j, k - 1)) return 'B';
  if (a == j && b == k - 1 && third(j - 1, k)) return 'C';
  if (a == j && b == k && third(j - 1, k - 1)) return 'D';
  if (a == k - 1 && b == j - 1 && third(j, k)) return 'E';
  if (a == k && b == j - 1 && third(j, k - 1)) return 'F';
  if (a == k - 1 && b == j && third(j - 1, k)) return 'G';
  if (a == k && b == j && third(j - 1, k - 1)) return 'H';
  return '-';
}

bool AreNamed(const KnotCode& code, int i, int j, int k) {
  return code.over(i - 1) && code.over(i) && code.over(j - 1) != code.over(j) && !code.over(k - 1) &&
         !code.over(k);
}

// The sign where two of the segments meet.
bool Plus(const KnotCode& code, int segment, int other) {
  const int mate = code.mate(segment - 1);
  return code.plus(mate == other - 1 || mate == other ? segment - 1 : segment);
}

bool RuleAcceptsR3(const KnotCode& before, const KnotCode& after, const Reading& reading,
                   const std::array<int, 3>& s) {
  const auto [i, j, k] = s;
  const int n = after.columns(), most = reading.whole_range ? n : n - 1;
  if (before.columns() != n || std::min({i, j, k}) < 2 || std::max({i, j, k}) > most) return false;
  const char type = TypeOf(before, i, j, k), later = TypeOf(after, i, j, k);
  if (type == '-' || later == '-' || (type - 'A') + (later - 'A') != 'H' - 'A') return false;
  if (!AreNamed(before, i, j, k) || (reading.named_at_both_times && !AreNamed(after, i, j, k))) return false;
  if (reading.faces && !(BoundsTriangle(before, s) && BoundsTriangle(after, s))) return false;
  if (reading.signs_kept &&
      (Plus(before, i, j) != Plus(after, i, j) || Plus(before, i, k) != Plus(after, i, k) ||
       Plus(before, j, k) != Plus(after, j, k)))
    return false;
  for (int c = 1; c <= n; ++c) {
    const bool removed = c == i - 1 || c == i || c == j - 1 || c == j || c == k - 1 || c == k;
    if (!removed && (before.mate(c) != after.mate(c) || before.attribute(c) != after.attribute(c)))
      return false;
  }
  return true;
}

bool RuleAccepts(const std::string& kind, const KnotCode& before, const KnotCode& after,
                 const Reading& reading, const std::array<int, 3>& segments) {
  return kind == "R2" ? RuleAcceptsR2(before, after, reading, segments[0], segments[1])
                      : RuleAcceptsR3(before, after, reading, segments);
}

}  // namespace

void CheckKnotMove(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"before", "move", "after"});
  const KnotCode before = ReadCodeOnSphere(At(certificate, "before")),
                 after = ReadCodeOnSphere(At(certificate, "after"));
  const Value& move = At(certificate, "move");
  ExpectMoveLeads(move, before, ReadKnotMove(move), after);
}

void CheckKnotRule(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"before", "after", "rule"}, {"misses", "accepts"});
  const KnotCode before = ReadCodeOnSphere(At(certificate, "before")),
                 after = ReadCodeOnSphere(At(certificate, "after"));
  const Value& rule = At(certificate, "rule");
  const std::string& kind = AsString(At(rule, "kind"));
  const Reading reading = ReadReading(rule, kind);
  const Value* misses = Find(certificate, "misses");
  const Value* accepts = Find(certificate, "accepts");
  if ((misses == nullptr) == (accepts == nullptr))
    throw Refused(&certificate, "expected one of misses and accepts");
  if (misses != nullptr) {
    const KnotMove move = ReadKnotMove(*misses);
    if (move.kind != kind || move.direction == "remove")
      throw Refused(misses, "is no move that the rule is about");
    ExpectMoveLeads(*misses, before, move, after);
    if (RuleAccepts(kind, before, after, reading, move.segments))
      throw Refused(misses, "the rule does find it");
    return;
  }
  const Array& list = AsArray(*accepts);
  if (list.size() != (kind == "R2" ? 2u : 3u))
    throw Refused(accepts, "not as many segments as the rule names");
  std::array<int, 3> segments{};
  for (std::size_t s = 0; s < list.size(); ++s)
    segments[s] = static_cast<int>(AsIndex(list[s], std::size_t{1} << 20));
  if (!RuleAccepts(kind, before, after, reading, segments))
    throw Refused(accepts, "the rule does not accept them");
  if (kind == "R2" ? AnyLensLeads(after, before) : AnyTriangleLeads(before, after))
    throw Refused(accepts, "such a move does lead there");
}

}  // namespace tact::check
