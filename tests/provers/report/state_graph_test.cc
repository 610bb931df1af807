#include "provers/report/state_graph.h"

#include <gtest/gtest.h>

#include "algebra/error.h"

namespace tact::provers {
namespace {

size_t Occurrences(const std::string& text, const std::string& part) {
  size_t count = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(StateGraph, HasABoxAStateAndAnArcAnEdge) {
  const std::string svg = DrawStateGraph({"free", "A\nedge-face", "B <"}, {{0, 1, StateLink::kSeen},
                                                                           {1, 2, StateLink::kSeen},
                                                                           {0, 2, StateLink::kValid},
                                                                           {2, 1, StateLink::kRejected}});
  EXPECT_EQ(Occurrences(svg, "<rect"), 3U);
  EXPECT_EQ(Occurrences(svg, "marker-end"), 2U);
  EXPECT_EQ(Occurrences(svg, "stroke-dasharray"), 1U);
  EXPECT_EQ(Occurrences(svg, ">B &lt;<"), 1U);
  EXPECT_EQ(Occurrences(svg, ">edge-face<"), 1U);
}

TEST(StateGraph, OneStateAloneIsAGraph) { EXPECT_EQ(Occurrences(DrawStateGraph({"free"}, {}), "<rect"), 1U); }

TEST(StateGraph, EdgesThatEndNowhereAreRefused) {
  EXPECT_THROW(DrawStateGraph({"a", "b"}, {{0, 2, StateLink::kSeen}}), PreconditionError);
  EXPECT_THROW(DrawStateGraph({"a", "b"}, {{1, 1, StateLink::kSeen}}), PreconditionError);
}

}  // namespace
}  // namespace tact::provers
