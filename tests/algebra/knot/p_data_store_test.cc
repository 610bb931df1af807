#include "algebra/knot/p_data_store.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "tests/algebra/knot/p_data_world.h"

namespace tact::knot {
namespace {

// 31, 32 and 33 intersections lie about the length where the code's columns get wider.
TEST(PDataStore, KeepsEachOnceAndGivesItBack) {
  std::mt19937_64 random(4);
  PDataStore store;
  std::map<PData, uint32_t> twin;
  for (int trial = 0; trial < 3000; ++trial) {
    const int crossings = trial % 100 < 97 ? trial % 5 : 31 + trial % 100 - 97;
    const PData p = RandomPData(random, crossings);
    EXPECT_EQ(store.Find(p), twin.count(p) == 1 ? twin.at(p) : PDataStore::kNone);
    const auto [number, is_new] = store.Insert(p);
    const auto [at, first] = twin.emplace(p, static_cast<uint32_t>(twin.size()));
    ASSERT_EQ(number, at->second);
    ASSERT_EQ(is_new, first);
  }
  ASSERT_EQ(store.size(), twin.size());
  for (const auto& [p, number] : twin) ASSERT_EQ(store.Get(number), p);
}

TEST(PDataStore, AnEmptyStoreHasNothing) { EXPECT_EQ(PDataStore().Find(PData()), PDataStore::kNone); }

}  // namespace
}  // namespace tact::knot
