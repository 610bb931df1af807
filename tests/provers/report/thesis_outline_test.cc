#include "provers/report/thesis_outline.h"

#include <gtest/gtest.h>

namespace tact::provers {
namespace {

Place Of(const std::string& source, const std::string& id = "x") {
  Claim claim;
  claim.id = id;
  claim.source = source;
  return PlaceOf(claim);
}

TEST(ThesisOutline, ThePlaceIsReadFromTheSourceElseFromTheId) {
  EXPECT_EQ(Of("2.2.1, Proposition 3"), (Place{"2", "2", "1"}));
  EXPECT_EQ(Of("Appendix A.4"), (Place{"A", "4"}));
  EXPECT_EQ(Of("Chapter 5"), (Place{"5"}));
  EXPECT_EQ(Of("2.3.2."), (Place{"2", "3", "2"}));
  EXPECT_EQ(Of("Table 5.1", "thesis.5.3.2.r2-rule"), (Place{"5", "3", "2"}));
  EXPECT_EQ(Of("Beyond", "thesis.A.4.optimal"), (Place{"A", "4"}));
  EXPECT_EQ(Of("Beyond", "ours.thing"), Place{});
  EXPECT_EQ(Of("Beyond"), Place{});
  EXPECT_EQ(Of("7.1"), Place{});
  EXPECT_EQ(Of("20 kinds"), Place{});
}

TEST(ThesisOutline, PlacesFollowTheThesisWithNumbersAsNumbers) {
  const std::vector<Place> in_order = {
      {"1"}, {"2"}, {"2", "2"}, {"2", "2", "1"}, {"2", "10"}, {"5", "1"}, {"A"}, {"B", "2"}, {}};
  for (size_t i = 0; i < in_order.size(); ++i) {
    for (size_t j = 0; j < in_order.size(); ++j)
      EXPECT_EQ(ComesBefore(in_order[i], in_order[j]), i < j) << i << " " << j;
  }
}

TEST(ThesisOutline, TitlesNameChapterAndSection) {
  EXPECT_EQ(ChapterTitle({"5", "3"}), "Chapter 5: Recognizing knot-tying tasks with one rope");
  EXPECT_EQ(ChapterTitle({"A"}), "Appendix A: Sub-skill implementation");
  EXPECT_EQ(ChapterTitle({}), "Beyond the thesis");
  EXPECT_EQ(SectionTitle({"2", "4", "1"}), "2.4 Sub-skills");
  EXPECT_EQ(SectionTitle({"2", "99"}), "2.99");
  EXPECT_EQ(SectionTitle({"2"}), "");
}

}  // namespace
}  // namespace tact::provers
