#include "robot/recognition/knot_recognition.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::recognition {
namespace {

using knot::Apply;
using knot::EquivalentPData;
using knot::Move;
using knot::PData;

// A rope tied by Cross moves of one end, the moves kept.
struct Tied {
  std::vector<PData> states = {PData()};
  std::vector<Move> moves;
};

Tied TieAtRandom(std::mt19937_64& random, int steps) {
  Tied tied;
  while (static_cast<int>(tied.moves.size()) < steps) {
    const auto all = AllMoves(tied.states.back(), 8);
    tied.moves.push_back(all[random() % all.size()]);
    tied.states.push_back(Apply(tied.states.back(), tied.moves.back()));
  }
  return tied;
}

TEST(KnotRecognition, TheMovesThatWereMadeAreAmongThoseRecognized) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 50; ++trial) {
    const Tied tied = TieAtRandom(random, 7);
    const KnotRecognition recognized = RecognizeKnot(tied.states);
    for (size_t t = 0; t < tied.moves.size(); ++t) {
      const auto& moves = recognized.transitions[t];
      EXPECT_TRUE(std::find(moves.begin(), moves.end(), tied.moves[t]) != moves.end());
    }
  }
}

// As in the thesis' second look at the bowline [5.4.2]: the wrong end in the third, sixth and seventh projection.
TEST(KnotRecognition, WrongEndsLeaveNoTransitionUnexplained) {
  std::mt19937_64 random(2);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<PData> states = TieAtRandom(random, 7).states;
    for (const size_t wrong : {2, 5, 6}) states[wrong] = EquivalentPData(states[wrong]);
    const KnotRecognition recognized = RecognizeKnot(states);
    int swapped = 0;
    for (size_t t = 0; t < states.size(); ++t) {
      if (t > 0) EXPECT_FALSE(recognized.transitions[t - 1].empty());
      if (recognized.ends[t] == EndRead::kSwapped) ++swapped;
      EXPECT_EQ(recognized.ends[t] == EndRead::kEither, states[t] == EquivalentPData(states[t]));
    }
    EXPECT_LE(swapped, 3);
  }
}

TEST(KnotRecognition, AGapIsSaidAndTheRestIsRecognized) {
  const PData loop({2, 1}, {1, 2}), knot({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});
  const KnotRecognition recognized = RecognizeKnot({PData(), loop, knot, knot});
  EXPECT_FALSE(recognized.transitions[0].empty());
  EXPECT_TRUE(recognized.transitions[1].empty());
  EXPECT_TRUE(recognized.transitions[2].empty());
}

TEST(KnotRecognition, OfNothingIsNothing) { EXPECT_TRUE(RecognizeKnot({}).ends.empty()); }

}  // namespace
}  // namespace tact::recognition
