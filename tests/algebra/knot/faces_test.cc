#include "algebra/knot/faces.h"

#include <gtest/gtest.h>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

const PData kOverhand({4, 5, 6, 1, 2, 3}, {3, 4, 3, 4, 3, 4});  // [thesis, 5.4.1]

// Codes by crossings: OEIS A373325 (semi-infinite curves of the plane; infinity is the selective end).
TEST(Faces, PlanarCodesAreAsManyAsPublished) {
  const std::vector<size_t> published = {1, 2, 10, 66, 498};
  for (int n = 0; n <= 4; ++n) {
    EXPECT_EQ(PlanarPData(n).size(), published[static_cast<size_t>(n)] << n);
  }
}

TEST(Faces, OfTheOverhandKnotAreTheFourOfTheThesisWithTheEndsPutBack) {
  const Faces faces(kOverhand);
  ASSERT_EQ(faces.count(), 4);
  // Edge e_k of the thesis' knot graph is segment k + 1. f1 = {e1, e4}, f2 = {e2, e5}, f3 = {e1, e5, e3},
  // f4 = {e4, e2, e3}; segments 1 and 7 reach into one face each and are met on both sides.
  std::vector<std::vector<int>> segments;
  for (int f = 0; f < 4; ++f) {
    std::vector<int> edges;
    for (const Dart d : faces.walk(f)) {
      if (d.segment != 1 && d.segment != 7) edges.push_back(d.segment - 1);
    }
    std::sort(edges.begin(), edges.end());
    segments.push_back(edges);
  }
  std::sort(segments.begin(), segments.end());
  EXPECT_EQ(segments, (std::vector<std::vector<int>>{{1, 3, 5}, {1, 4}, {2, 3, 4}, {2, 5}}));
}

TEST(Faces, EveryDartIsOnOneWalk) {
  for (const PData& p : PlanarPData(3)) {
    const Faces faces(p);
    size_t darts = 0;
    for (int f = 0; f < faces.count(); ++f) {
      darts += faces.walk(f).size();
      for (const Dart d : faces.walk(f)) {
        EXPECT_EQ(faces.left_of(d), f);
        EXPECT_EQ(faces.left_of(NextDart(p, d)), f);
      }
    }
    EXPECT_EQ(darts, 2 * static_cast<size_t>(p.segments()));
    EXPECT_EQ(faces.count(), CountFaces(p));
  }
}

TEST(Faces, ATwistedPairOfTheWrongTurnsNeedsATorus) {
  EXPECT_EQ(Genus(PData({3, 4, 1, 2}, {3, 3, 4, 4})), 1);
  EXPECT_EQ(Genus(PData({3, 4, 1, 2}, {3, 4, 4, 3})), 0);
}

}  // namespace
}  // namespace tact::knot
