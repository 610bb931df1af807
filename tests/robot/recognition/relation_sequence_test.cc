#include "robot/recognition/relation_sequence.h"

#include <gtest/gtest.h>

#include <limits>

#include "robot/perception/random_numbers.h"

namespace tact::recognition {
namespace {

TEST(RelationSequence, OneSceneTakesItsCheapestCandidate) {
  const RelationSequence found =
      FindRelationSequence({{3, 1, 2}}, [](size_t, size_t, size_t) { return 0.0; });
  EXPECT_EQ(found.chosen, (std::vector<size_t>{1}));
  EXPECT_EQ(found.cost, 1);
}

TEST(RelationSequence, AChangeMustPayForItself) {
  const auto step = [](size_t, size_t from, size_t to) { return from == to ? 0.0 : 2.0; };
  EXPECT_EQ(FindRelationSequence({{0, 5}, {1, 0}, {0, 5}}, step).chosen, (std::vector<size_t>{0, 0, 0}));
  EXPECT_EQ(FindRelationSequence({{0, 5}, {5, 0}, {0, 5}}, step).chosen, (std::vector<size_t>{0, 1, 0}));
}

// The twin: every sequence there is.
TEST(RelationSequence, NoOtherSequenceIsCheaper) {
  perception::RandomNumbers random(3);
  for (int world = 0; world < 200; ++world) {
    std::vector<std::vector<double>> costs(4);
    for (auto& scene : costs) {
      scene.resize(1 + static_cast<size_t>(3 * random.Uniform()));
      for (double& cost : scene) cost = random.Uniform();
    }
    double table[4][3][3];
    for (auto& a : table)
      for (auto& b : a)
        for (double& c : b) c = random.Uniform();
    const auto step = [&](size_t k, size_t from, size_t to) { return table[k][from][to]; };
    const auto cost_of = [&](const std::vector<size_t>& chosen) {
      double sum = costs[0][chosen[0]];
      for (size_t k = 1; k < 4; ++k) sum += costs[k][chosen[k]] + table[k][chosen[k - 1]][chosen[k]];
      return sum;
    };
    double least = std::numeric_limits<double>::infinity();
    std::vector<size_t> chosen(4);
    for (chosen[0] = 0; chosen[0] < costs[0].size(); ++chosen[0])
      for (chosen[1] = 0; chosen[1] < costs[1].size(); ++chosen[1])
        for (chosen[2] = 0; chosen[2] < costs[2].size(); ++chosen[2])
          for (chosen[3] = 0; chosen[3] < costs[3].size(); ++chosen[3])
            least = std::min(least, cost_of(chosen));
    const RelationSequence found = FindRelationSequence(costs, step);
    EXPECT_NEAR(found.cost, least, 1e-12);
    EXPECT_NEAR(cost_of(found.chosen), least, 1e-12);
  }
}

}  // namespace
}  // namespace tact::recognition
