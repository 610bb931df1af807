#include "algebra/knot/columns.h"

#include <gtest/gtest.h>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// An intersection put between any two places of any P-data, planar or not.
TEST(Columns, WhatIsPutInComesOutAgain) {
  for (int n = 0; n <= 2; ++n) {
    ForEachPData(n, [](const PData& p) {
      for (int first = 1; first <= p.segments(); ++first) {
        for (int second = first; second <= p.segments(); ++second) {
          const Renumbering to = {first, 1, second, 1};
          const NewColumn a{first, second + 1, 3}, b{second + 1, first, 4};
          const PData q = InsertColumns(p, to, {a, b});
          ASSERT_FALSE(PData::FindFault(q.SigmaRow(), q.AttrRow()));
          ASSERT_EQ(q.sigma(first), second + 1);
          ASSERT_EQ(q.attr(second + 1), 4);
          ASSERT_TRUE(EqualBut(p, to, q));
          ASSERT_EQ(RemoveColumns(q, {first, second + 1}), p);
        }
      }
    });
  }
}

// By hand: the second intersection of the thesis' example [5.1.2] taken out.
TEST(Columns, TheOthersAreRenumbered) {
  const PData p({4, 5, 6, 1, 2, 3}, {3, 1, 2, 4, 2, 1});
  EXPECT_EQ(RemoveColumns(p, {2, 5}), PData({3, 4, 1, 2}, {3, 2, 4, 1}));
}

TEST(Columns, OneOtherAttributeIsNoticed) {
  const PData p({2, 1}, {1, 2});
  EXPECT_TRUE(EqualBut(p, Renumbering{1, 2}, PData({2, 1, 4, 3}, {3, 4, 1, 2})));
  EXPECT_FALSE(EqualBut(p, Renumbering{1, 2}, PData({2, 1, 4, 3}, {1, 2, 3, 4})));
}

}  // namespace
}  // namespace tact::knot
