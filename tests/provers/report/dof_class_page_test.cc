#include "provers/report/dof_class_page.h"

#include <gtest/gtest.h>

#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

using enumerators::DofCensus;

size_t Occurrences(const std::string& text, const std::string& word) {
  size_t count = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

std::string Page(const DofCensus& census) {
  return DofClassPage(census, enumerators::ListDofClasses(census.Count()));
}

TEST(DofClassPage, HasEveryClassWithADrawingAndIsWellFormed) {
  const DofCensus census(enumerators::CubeWorld(3));
  const auto lists = enumerators::ListDofClasses(census.Count());
  const std::string page = Page(census);
  EXPECT_EQ(ReadXml(page).error, "");
  EXPECT_EQ(Occurrences(page, "<article"), lists.back().found.size());
  EXPECT_EQ(Occurrences(page, "<svg"), lists.back().found.size() + lists.front().found.size());
  for (const enumerators::DofLemma& lemma : enumerators::DofLemmas())
    EXPECT_NE(page.find("<td>" + lemma.id), std::string::npos) << lemma.id;
}

TEST(DofClassPage, NeedsNothingFromElsewhere) {
  const std::string page = Page(DofCensus(enumerators::CubeWorld(2)));
  EXPECT_EQ(Occurrences(page, "src="), 0U);
  EXPECT_EQ(Occurrences(page, "href="), 0U);
  EXPECT_EQ(Occurrences(page, "url("), 0U);
}

TEST(DofClassPage, SaysWhetherTheListIsComplete) {
  EXPECT_NE(Page(DofCensus(enumerators::CornerWorld(1))).find("2 of the 142 classes"), std::string::npos);
  EXPECT_NE(Page(DofCensus(enumerators::CubeWorld(1))).find("have 139 at most"), std::string::npos);
  EXPECT_EQ(Page(DofCensus(enumerators::CornerWorld(1))).find("complete list"), std::string::npos);
}

}  // namespace
}  // namespace tact::provers
