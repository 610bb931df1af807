#include "provers/claims/knot_outlines.h"

#include <gtest/gtest.h>

#include <set>

#include "algebra/knot/reducible.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::provers {
namespace {

using knot::PData;

// Codes by crossings: OEIS A373325.
TEST(KnotOutlines, AreAsManyAsPublishedCodes) {
  const std::vector<size_t> published = {1, 2, 10, 66, 498};
  for (int n = 0; n <= 4; ++n) EXPECT_EQ(Outlines(n).size(), published[static_cast<size_t>(n)]);
}

// Brute: every array, forgotten down to its outline.
TEST(KnotOutlines, StandForEveryPDataOnceAndAreTheLeast) {
  for (int n = 0; n <= 3; ++n) {
    std::set<PData> outlines, irreducible;
    for (const PData& p : knot::PlanarPData(n)) {
      const PData outline = OutlineOf(p);
      EXPECT_LE(outline, p);
      EXPECT_EQ(OutlineOf(outline), outline);
      EXPECT_EQ(OutlineOf(MirrorShape(p)), outline);
      EXPECT_EQ(OutlineOf(MirrorHeights(p)), outline);
      outlines.insert(outline);
      if (IsIrreducible(p)) irreducible.insert(outline);
    }
    // Of two mirror images Outlines has both.
    EXPECT_EQ(outlines.size() * (n > 0 ? 2 : 1), Outlines(n).size());
    EXPECT_EQ(std::vector<PData>(irreducible.begin(), irreducible.end()), IrreducibleOutlines(n));
  }
}

TEST(KnotOutlines, RandomOnesAreIrreducibleOnASphereAndTheSameEachTime) {
  const auto outlines = RandomIrreducibleOutlines(Effort::kQuick);
  EXPECT_FALSE(outlines.empty());
  for (const PData& p : outlines)
    EXPECT_TRUE(IsPlanar(p) && IsIrreducible(p) && OutlineOf(p) == p) << p.ToJson();
  EXPECT_EQ(RandomIrreducibleOutlines(Effort::kQuick), outlines);
}

TEST(KnotOutlines, TheLeastFailureIsKept) {
  const PData overhand({4, 5, 6, 1, 2, 3}, {1, 2, 1, 2, 1, 2});
  const auto trial = TryIrreducible(Effort::kQuick, 2, [&](const PData& p) { return p < overhand; });
  EXPECT_EQ(trial.first, overhand);
  EXPECT_EQ(trial.failures, trial.outlines + trial.random - 1);
  EXPECT_EQ(Judge(trial, "").verdict, Verdict::kRefuted);
  EXPECT_EQ(Judge(TryIrreducible(Effort::kQuick, 2, [](const PData&) { return true; }), "").verdict,
            Verdict::kHoldsTo);
}

}  // namespace
}  // namespace tact::provers
