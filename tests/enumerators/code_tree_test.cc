#include "enumerators/code_tree.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

#include "enumerators/planar_p_data.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::enumerators {
namespace {

using Rows = std::pair<std::vector<int>, std::vector<int>>;

Rows RowsOf(const Code& code) {
  Rows rows;
  for (int i = 1; i <= code.columns; ++i) {
    rows.first.push_back(code.sigma[static_cast<size_t>(i)]);
    rows.second.push_back(code.turn[static_cast<size_t>(i)]);
  }
  return rows;
}

// Brute: all pairings with all attributes, those that a sphere holds.
TEST(CodeTree, HasEachCodeThatASphereHoldsOnce) {
  for (int n = 0; n <= 4; ++n) {
    std::set<Rows> brute, grown;
    knot::ForEachPData(n, [&](const knot::PData& p) {
      if (!knot::IsPlanar(p)) return;
      Rows rows{p.SigmaRow(), {}};
      for (int i = 1; i <= p.columns(); ++i) rows.second.push_back(p.turn(i));
      brute.insert(rows);
    });
    ForEachCode(n, [&](const Code& code) { EXPECT_TRUE(grown.insert(RowsOf(code)).second); });
    EXPECT_EQ(grown, brute);
  }
}

// A row's last entry moves when Cross writes it: the largest codes that there is room for.
TEST(CodeTree, GrowsToItsBound) {
  Code code;
  while (code.crossings() < Code::kMostCrossings) {
    const TipFace face = TipFaceOf(code);
    Code grown;
    Cross(code, face.darts[static_cast<size_t>(face.size / 2)], grown);
    code = grown;
    EXPECT_EQ(knot::Genus(WithHeights(code, 0)), 0);
  }
}

TEST(CodeTree, WalksFacesAsTheFacesOfPDataAreWalked) {
  ForEachCode(4, [](const Code& code) {
    const knot::PData p = WithHeights(code, 5);
    const knot::Faces faces(p);
    const TipFace face = TipFaceOf(code);
    const auto& walk = faces.walk(faces.left_of({p.segments(), false}));
    ASSERT_EQ(static_cast<size_t>(face.size), walk.size());
    for (int i = 0; i < face.size; ++i) {
      const CodeDart d = face.darts[static_cast<size_t>(i)];
      EXPECT_EQ(faces.left_of({d.segment, d.forward}), faces.left_of({p.segments(), false}));
    }
  });
}

// The order of growth: the choices at each intersection, as numbers of darts on the walk, increase.
TEST(CodeTree, VisitsInTheOrderOfTheChoices) {
  std::vector<Rows> visited, expected;
  ForEachCode(3, [&](const Code& code) { visited.push_back(RowsOf(code)); });
  std::vector<Code> level = {Code()};
  for (int n = 0; n < 3; ++n) {
    std::vector<Code> next;
    for (const Code& code : level) {
      const TipFace face = TipFaceOf(code);
      for (int i = 0; i < face.size; ++i)
        Cross(code, face.darts[static_cast<size_t>(i)], next.emplace_back());
    }
    level = next;
  }
  for (const Code& code : level) expected.push_back(RowsOf(code));
  EXPECT_EQ(visited, expected);
}

}  // namespace
}  // namespace tact::enumerators
