#include "enumerators/shown_transitions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace tact::enumerators {
namespace {

const std::vector<ShownScene>& Scenes() {
  static const std::vector<ShownScene> scenes = ShowScenes();
  return scenes;
}

TEST(ShownScenes, AreOneForEachPairOfIndices) {
  std::set<std::pair<algebra::DofIndex, algebra::DofIndex>> pairs;
  for (const ShownScene& scene : Scenes()) {
    EXPECT_NE(scene.given.before, scene.given.after);
    EXPECT_TRUE(pairs.insert(std::minmax(scene.given.before, scene.given.after)).second);
  }
  EXPECT_EQ(pairs.size(), 15U);  // of six
}

TEST(ShownScenes, KeepTheirDofsUntilTheEnd) {
  for (const ShownScene& scene : Scenes()) {
    EXPECT_EQ(scene.dof_before, ComputeMotionDof(FollowScene(scene.given.scene).middle.relation))
        << scene.given.story;
  }
}

TEST(ShownTransitions, AreAllSixtyEachByASceneThatShowsIt) {
  const auto shown = ShownTransitions(Scenes());
  EXPECT_EQ(shown.size(), 60U);
  std::set<algebra::DofTransition> kinds;
  for (const ShownTransition& s : shown) {
    const algebra::DofTransition t = s.transition;
    EXPECT_TRUE(kinds.insert(t).second);
    ASSERT_TRUE(s.scene.has_value());
    const ShownScene& scene = Scenes()[*s.scene];
    const auto before = Indices(s.backwards ? scene.dof_after : scene.dof_before, t.motion);
    const auto after = Indices(s.backwards ? scene.dof_before : scene.dof_after, t.motion);
    const auto from = static_cast<size_t>(t.from), to = static_cast<size_t>(t.to);
    EXPECT_GT(before[from], 0);
    EXPECT_GT(after[to], 0);
    if (!s.forced) continue;
    EXPECT_GT(before[from], after[from]);
    EXPECT_LT(before[to], after[to]);
  }
}

TEST(ShownTransitions, WithoutScenesNothingIsShown) {
  for (const ShownTransition& s : ShownTransitions({})) EXPECT_FALSE(s.scene.has_value());
}

}  // namespace
}  // namespace tact::enumerators
