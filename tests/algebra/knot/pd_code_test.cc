#include "algebra/knot/pd_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "algebra/error.h"
#include "algebra/knot/closure.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// Knoto-ID, examples/3_1L_diagram_open_PD.txt; its Gauss code "-1 2 -3 1 -2 3 ---" says: first strand under, all signs -.
const PData kKnotoId({4, 5, 6, 1, 2, 3}, {2, 1, 2, 1, 2, 1});

TEST(PdCode, AgreesWithKnotoIdsFile) {
  EXPECT_EQ(ToText(PdCodeOf(kKnotoId)), "PD[X[0,3,1,4],X[4,1,5,2],X[2,5,3,6]]");
  EXPECT_EQ(PDataOf({{{0, 3, 1, 4}, {4, 1, 5, 2}, {2, 5, 3, 6}}}), kKnotoId);
}

// Knoto-ID, examples/3_1_diagram_closed_PD.txt has arcs 0,3,1,4; 4,1,5,2; 2,5,3,0: ours with arc 0 called 6.
TEST(PdCode, OfAClosedKnotAgreesWithKnotoIdsFile) {
  const PdCode code = ClosedPdCodeOf(kKnotoId);
  // Arcs are counted from 1 here, so each number is one more.
  EXPECT_EQ(ToText(code), "PD[X[1,4,2,5],X[5,2,6,3],X[3,6,4,1]]");
  std::map<int, int> seen;
  for (const auto& arcs : code.crossings) {
    for (const int arc : arcs) ++seen[arc];
  }
  for (int arc = 1; arc <= 6; ++arc) EXPECT_EQ(seen[arc], 2);
}

TEST(PdCode, NothingIsLostOnAnyPDataToFourCrossings) {
  for (int c = 0; c <= 4; ++c) {
    ForEachPData(c, [](const PData& p) {
      const PdCode code = PdCodeOf(p);
      ASSERT_FALSE(FindPdFault(code)) << p.ToJson();
      ASSERT_EQ(PDataOf(code), p) << p.ToJson();
    });
  }
}

TEST(PdCode, NothingIsLostOnRandomRopesToFortyCrossings) {
  std::mt19937_64 random(13);
  for (int crossings = 5; crossings <= 40; ++crossings) {
    const PData p = RandomPData(random, crossings);
    EXPECT_EQ(PDataOf(PdCodeOf(p)), p) << p.ToJson();
  }
}

// A face's corners read off the code alone: arcs next to each other counterclockwise bound a face. Its count must be the
// one that the turns of P-data give, so the code has the shape that P-data have.
TEST(PdCode, CornersMakeTheSameFaces) {
  for (int c = 1; c <= 3; ++c) {
    ForEachPData(c, [](const PData& p) {
      // A dart: arc and whether it leads to the place; places are (crossing, position).
      const PdCode code = PdCodeOf(p);
      const int crossings = p.crossings();
      std::vector<std::vector<int>> places(static_cast<size_t>(p.segments()));
      for (int x = 0; x < crossings; ++x) {
        for (int k = 0; k < 4; ++k) {
          const int arc = code.crossings[static_cast<size_t>(x)][static_cast<size_t>(k)];
          places[static_cast<size_t>(arc)].push_back(4 * x + k);
        }
      }
      std::vector<bool> seen(4 * static_cast<size_t>(crossings), false);
      int faces = 0;
      for (size_t start = 0; start < seen.size(); ++start) {
        if (seen[start]) continue;
        ++faces;
        for (size_t at = start; !seen[at];) {
          seen[at] = true;
          // Leave by the arc at this place; where it ends, go on with the next place clockwise: the face on the left.
          const int arc = code.crossings[at / 4][at % 4];
          const auto& ends = places[static_cast<size_t>(arc)];
          const int here = static_cast<int>(at);
          const int there = ends.size() == 1 ? here : ends[0] == here ? ends[1] : ends[0];
          at = static_cast<size_t>(there / 4 * 4 + (there + 3) % 4);
        }
      }
      ASSERT_EQ(faces, CountFaces(p)) << p.ToJson();
    });
  }
}

TEST(PdCode, EveryChangedArcIsRefusedOrAnother) {
  const PdCode good = PdCodeOf(kKnotoId);
  for (size_t x = 0; x < 3; ++x) {
    for (size_t k = 0; k < 4; ++k) {
      for (int arc = -1; arc <= 7; ++arc) {
        PdCode bad = good;
        bad.crossings[x][k] = arc;
        if (bad == good) continue;
        if (FindPdFault(bad)) {
          EXPECT_THROW(PDataOf(bad), PreconditionError);
        } else {
          ADD_FAILURE() << "accepted " << ToText(bad);
        }
      }
    }
  }
  EXPECT_NE(FindPdFault(ClosedPdCodeOf(kKnotoId))->what.find("closed knot"), std::string::npos);
}

}  // namespace
}  // namespace tact::knot
