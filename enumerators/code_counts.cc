#include "enumerators/code_counts.h"

#include "enumerators/unit_text.h"

namespace tact::enumerators {
namespace {

struct Interlacement {
  int classes = 0;
  bool all_lead_right = true;  // each class' first column has the turn +1
};

// As knot::InterlacementClasses: intersections met once so far lie in runs, by first columns; meeting one again joins its run
// with all later ones.
Interlacement InterlacementOf(const Code& code) {
  struct Run {
    int first, open;
  };
  std::array<Run, Code::kMostCrossings + 1> runs;
  size_t count = 0;
  Interlacement found;
  for (int i = 1; i <= code.columns; ++i) {
    const int mate = code.sigma[static_cast<size_t>(i)];
    if (mate > i) {
      runs[count++] = {i, 1};
      continue;
    }
    while (runs[count - 1].first > mate) {
      runs[count - 2].open += runs[count - 1].open;
      --count;
    }
    if (--runs[count - 1].open > 0) continue;
    --count;
    ++found.classes;
    if (code.turn[static_cast<size_t>(runs[count].first)] < 0) found.all_lead_right = false;
  }
  return found;
}

// Whether reading the code from the other end, each turn times `mirror`, gives the same.
bool IsOwnReversal(const Code& code, int mirror) {
  for (int i = 1, j = code.columns; i <= code.columns; ++i, --j) {
    const auto at = static_cast<size_t>(i), back = static_cast<size_t>(j);
    if (code.sigma[at] + code.sigma[back] != code.columns + 1 || code.turn[at] != mirror * code.turn[back])
      return false;
  }
  return true;
}

bool HoldsSelectiveEnd(const TipFace& face) {
  for (int i = 0; i < face.size; ++i) {
    if (face.darts[static_cast<size_t>(i)] == CodeDart{1, true}) return true;
  }
  return false;
}

void Count(const Code& code, std::vector<CodeCounts>& counts) {
  CodeCounts& of = counts[static_cast<size_t>(code.crossings())];
  const TipFace face = TipFaceOf(code);
  const Interlacement interlacement = InterlacementOf(code);
  ++of.codes;
  of.pairings += interlacement.all_lead_right ? 1 : 0;
  of.irreducible += interlacement.classes <= 1 ? 1 : 0;
  of.reversible += IsOwnReversal(code, 1) ? 1 : 0;
  of.mirror_reversible += IsOwnReversal(code, -1) ? 1 : 0;
  of.ends_on_one_face += HoldsSelectiveEnd(face) ? 1 : 0;
  if (code.crossings() + 1 == static_cast<int>(counts.size())) return;
  Code grown;
  for (int i = 0; i < face.size; ++i) {
    Cross(code, face.darts[static_cast<size_t>(i)], grown);
    Count(grown, counts);
  }
}

}  // namespace

CodeCounts& CodeCounts::operator+=(const CodeCounts& other) {
  codes += other.codes;
  pairings += other.pairings;
  irreducible += other.irreducible;
  reversible += other.reversible;
  mirror_reversible += other.mirror_reversible;
  ends_on_one_face += other.ends_on_one_face;
  return *this;
}

uint64_t UpToReversal(const CodeCounts& counts) { return (counts.codes + counts.reversible) / 2; }
uint64_t UpToMirror(const CodeCounts& counts) { return (counts.codes + 1) / 2; }
uint64_t UpToBoth(const CodeCounts& counts) {
  const uint64_t own_mirror = counts.codes % 2;  // the straight rope alone
  return (counts.codes + own_mirror + counts.reversible + counts.mirror_reversible) / 4;
}

std::vector<CodeCounts> CountCodesFrom(const Code& code, int crossings) {
  std::vector<CodeCounts> counts(static_cast<size_t>(crossings) + 1);
  if (code.crossings() <= crossings) Count(code, counts);
  return counts;
}

std::string ToText(const std::vector<CodeCounts>& counts) {
  std::string text = "[";
  for (const CodeCounts& c : counts) {
    text +=
        (text.size() > 1 ? "," : "") + ListText<uint64_t>({c.codes, c.pairings, c.irreducible, c.reversible,
                                                           c.mirror_reversible, c.ends_on_one_face});
  }
  return text + "]";
}

std::vector<CodeCounts> ParseCodeCounts(std::string_view text) {
  TextReader reader(text);
  std::vector<CodeCounts> counts;
  reader.Expect("[");
  while (!reader.Take("]")) {
    if (!counts.empty()) reader.Expect(",");
    const std::vector<uint64_t> n = reader.Numbers<uint64_t>();
    if (n.size() != 6) reader.Refuse("six counts");
    counts.push_back({n[0], n[1], n[2], n[3], n[4], n[5]});
  }
  reader.ExpectEnd();
  return counts;
}

}  // namespace tact::enumerators
