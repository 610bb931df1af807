#include "enumerators/code_counts.h"

#include <gtest/gtest.h>

#include <set>

#include "algebra/error.h"
#include "algebra/knot/reducible.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::enumerators {
namespace {

using knot::PData;

// A row's counts of one kind.
template <typename Get>
std::vector<uint64_t> Column(const std::vector<CodeCounts>& counts, const Get& get) {
  std::vector<uint64_t> column;
  for (const CodeCounts& c : counts) column.push_back(get(c));
  return column;
}

TEST(CodeCounts, AreThePublishedOnes) {
  const std::vector<CodeCounts> counts = CountCodes(7);
  // OEIS A373325 and A054993.
  EXPECT_EQ(Column(counts, [](const CodeCounts& c) { return c.codes; }),
            (std::vector<uint64_t>{1, 2, 10, 66, 498, 4072, 35144, 315352}));
  EXPECT_EQ(Column(counts, [](const CodeCounts& c) { return c.ends_on_one_face; }),
            (std::vector<uint64_t>{1, 2, 8, 42, 260, 1796, 13396, 105706}));
}

// The code of a P-data: heights all alike as far as they can be.
PData CodeOf(const PData& p) {
  knot::PDataBuilder code(p.columns());
  for (int i = 1; i <= p.columns(); ++i) code.Add(p.sigma(i), knot::AttributeOf(i < p.sigma(i), p.turn(i)));
  return code.Take();
}
PData ReversedCode(const PData& p) { return CodeOf(EquivalentPData(p)); }
PData MirroredCode(const PData& p) { return CodeOf(MirrorShape(p)); }

// Brute: orbits and sets among all pairings with all attributes.
TEST(CodeCounts, AgreeWithTheSetsThatTheyCount) {
  const std::vector<CodeCounts> counts = CountCodes(4);
  for (int n = 0; n <= 4; ++n) {
    std::set<PData> codes, irreducible, reversal, mirror, both, one_face;
    std::set<std::vector<int>> pairings;
    uint64_t p_data = 0;
    knot::ForEachPData(n, [&](const PData& any) {
      if (!knot::IsPlanar(any)) return;
      ++p_data;
      const PData p = CodeOf(any), r = ReversedCode(p), m = MirroredCode(p), rm = ReversedCode(m);
      codes.insert(p);
      pairings.insert(p.SigmaRow());
      if (knot::IsIrreducible(p)) irreducible.insert(p);
      reversal.insert(std::min(p, r));
      mirror.insert(std::min(p, m));
      both.insert(std::min({p, r, m, rm}));
      const knot::Faces faces(p);
      if (faces.left_of({1, true}) == faces.left_of({p.segments(), true})) one_face.insert(p);
    });
    const CodeCounts& c = counts[static_cast<size_t>(n)];
    EXPECT_EQ(p_data, c.codes << n);
    EXPECT_EQ(codes.size(), c.codes);
    EXPECT_EQ(pairings.size(), c.pairings);
    EXPECT_EQ(irreducible.size(), c.irreducible);
    EXPECT_EQ(reversal.size(), UpToReversal(c));
    EXPECT_EQ(mirror.size(), UpToMirror(c));
    EXPECT_EQ(both.size(), UpToBoth(c));
    EXPECT_EQ(one_face.size(), c.ends_on_one_face);
  }
}

TEST(CodeCounts, OfSubtreesAddUp) {
  std::vector<CodeCounts> sum(7);
  ForEachCode(3, [&](const Code& code) {
    const std::vector<CodeCounts> part = CountCodesFrom(code, 6);
    for (size_t n = 0; n < sum.size(); ++n) sum[n] += part[n];
  });
  const std::vector<CodeCounts> whole = CountCodes(6);
  for (size_t n = 3; n < sum.size(); ++n) EXPECT_EQ(sum[n], whole[n]);
  EXPECT_EQ(CountCodesFrom(Code(), 0), (std::vector<CodeCounts>{{1, 1, 1, 1, 1, 1}}));
}

TEST(CodeCounts, AsTextComeBack) {
  const std::vector<CodeCounts> counts = CountCodes(5);
  EXPECT_EQ(ParseCodeCounts(ToText(counts)), counts);
  EXPECT_EQ(ToText(CountCodes(1)), "[[1,1,1,1,1,1],[2,1,2,0,2,2]]");
  for (const char* bad :
       {"", "[", "[[1,2,3]]", "[[1,1,1,1,1,1]", "[[1,1,1,1,1,1][2,1,2,0,2,2]]", "[[1,1,1,1,1,-1]]", "[] "})
    EXPECT_THROW(ParseCodeCounts(bad), InputError) << bad;
}

}  // namespace
}  // namespace tact::enumerators
