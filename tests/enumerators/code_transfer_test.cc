#include "enumerators/code_transfer.h"

#include <gtest/gtest.h>

#include "enumerators/code_counts.h"

namespace tact::enumerators {
namespace {

// OEIS A373325 has these; tests of code_tree.h visit the first ones.
const std::vector<uint64_t> kPublished = {1,     2,      10,      66,       498,       4072,
                                          35144, 315352, 2914074, 27553880, 265387528, 2595131328};

TEST(CodeTransfer, CountsWhatIsPublished) { EXPECT_EQ(CountCodesByTransfer(11), kPublished); }

TEST(CodeTransfer, AgreesWithTheCodesVisited) {
  const std::vector<CodeCounts> visited = CountCodes(7);
  const std::vector<uint64_t> transferred = CountCodesByTransfer(7);
  ASSERT_EQ(visited.size(), transferred.size());
  for (size_t n = 0; n < visited.size(); ++n) EXPECT_EQ(visited[n].codes, transferred[n]);
}

TEST(CodeTransfer, DoesNotDependOnTheBound) {
  for (int n = 0; n <= 8; ++n) {
    const std::vector<uint64_t> counts = CountCodesByTransfer(n);
    EXPECT_EQ(counts, std::vector<uint64_t>(kPublished.begin(), kPublished.begin() + n + 1));
  }
}

TEST(CodeTransfer, TellsHowFarItIs) {
  int layers = 0;
  CountCodesByTransfer(5, [&](const TransferProgress& at) {
    EXPECT_EQ(at.layer, layers++);
    EXPECT_GE(at.states, 1U);
    EXPECT_EQ(at.layers, 11);
  });
  EXPECT_EQ(layers, 11);
}

// The codes with ten intersections, visited one by one.
TEST(FullCodeTransfer, AgreesWithTheCodesVisitedToTen) {
  uint64_t codes = 0;
  ForEachCode(10, [&](const Code&) { ++codes; });
  EXPECT_EQ(codes, CountCodesByTransfer(10).back());
}

}  // namespace
}  // namespace tact::enumerators
