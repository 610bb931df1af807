#include "algebra/knot/p_data.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

std::string Fault(const std::vector<int>& sigma, const std::vector<int>& attr) {
  const auto fault = PData::FindFault(sigma, attr);
  return fault ? fault->what : "";
}

TEST(PData, TheThesisExampleReadsAsItSays) {
  const PData p({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1});  // [thesis, 5.1.2]
  EXPECT_EQ(p.columns(), 6);
  EXPECT_EQ(p.sigma(2), 5);
  EXPECT_EQ(p.attr(3), 2);
  EXPECT_TRUE(IsPlanar(p));
  EXPECT_EQ(p.ToJson(), "{\"sigma\":[4,5,6,1,2,3],\"attr\":[3,1,2,4,2,1]}");
}

TEST(PData, WhatIsNoneIsRefusedWithAReason) {
  EXPECT_EQ(Fault({2, 1}, {1, 2}), "");
  EXPECT_EQ(Fault({2, 1}, {1}), "expected as many attributes as mates, got 1 and 2");
  EXPECT_EQ(Fault({1}, {1}), "expected two columns for each intersection, got 1");
  EXPECT_EQ(Fault({1, 2}, {1, 2}), "expected another column as mate, got sigma(1) = 1");
  EXPECT_EQ(Fault({3, 1}, {1, 2}), "expected a mate from 1 to 2, got sigma(1) = 3");
  EXPECT_EQ(Fault({2, 3, 4, 1}, {1, 2, 1, 2}), "expected sigma(2) = 1 since sigma(1) = 2, got 3");
  EXPECT_EQ(Fault({2, 1}, {1, 5}), "expected an attribute from 1 to 4, got attr(2) = 5");
  EXPECT_EQ(Fault({2, 1}, {1, 1}),
            "expected one strand over and one under at the intersection of columns 1 and 2, got attributes 1 "
            "and 1");
  EXPECT_EQ(
      Fault({2, 1}, {1, 4}),
      "expected one sign on both strands at the intersection of columns 1 and 2, got attributes 1 and 4");
  EXPECT_THROW(PData({2, 1}, {1, 1}), PreconditionError);
}

TEST(PData, BeingReadFromTheOtherEndTwiceIsNothing) {
  for (int n = 0; n <= 3; ++n) {
    ForEachPData(n, [](const PData& p) {
      const PData e = EquivalentPData(p);
      ASSERT_EQ(EquivalentPData(e), p);
      ASSERT_EQ(Genus(e), Genus(p));
      ASSERT_EQ(CanonicalPData(e), CanonicalPData(p));
      for (int i = 1; i <= p.columns(); ++i) ASSERT_EQ(e.turn(p.columns() + 1 - i), p.turn(i));
    });
  }
}

TEST(PData, MirrorsTurnTheSignAndKeepTheSphere) {
  for (int n = 0; n <= 3; ++n) {
    ForEachPData(n, [](const PData& p) {
      const PData shape = MirrorShape(p), heights = MirrorHeights(p);
      ASSERT_EQ(MirrorShape(shape), p);
      ASSERT_EQ(MirrorHeights(heights), p);
      ASSERT_EQ(Genus(shape), Genus(p));
      ASSERT_EQ(Genus(heights), Genus(p));
      for (int i = 1; i <= p.columns(); ++i) {
        ASSERT_EQ(shape.turn(i), -p.turn(i));
        ASSERT_EQ(shape.over(i), p.over(i));
        ASSERT_EQ(heights.turn(i), p.turn(i));
        ASSERT_NE(heights.over(i), p.over(i));
      }
    });
  }
}

}  // namespace
}  // namespace tact::knot
