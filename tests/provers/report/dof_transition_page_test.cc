#include "provers/report/dof_transition_page.h"

#include <gtest/gtest.h>

#include "tests/provers/report/xml_check.h"

namespace tact::provers {
namespace {

size_t Occurrences(const std::string& text, const std::string& word) {
  size_t count = 0;
  for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

struct Made {
  explicit Made(size_t contacts) : census(enumerators::CornerWorld(contacts)) {
    const enumerators::DofSteps steps = census.Count();
    DofTransitionFindings findings{census,
                                   enumerators::ListDofSteps(steps),
                                   enumerators::CountDirectBlocks(steps),
                                   enumerators::TranslationSteps(4),
                                   enumerators::ShowScenes(),
                                   {}};
    findings.shown = enumerators::ShownTransitions(findings.scenes);
    pairs = CountPairs(findings.lists, enumerators::DofDefinitions().size() - 1);
    page = DofTransitionPage(findings);
  }

  enumerators::DofStepCensus census;
  size_t pairs = 0;
  std::string page;
};

TEST(DofTransitionPage, IsWellFormedAndHasEverySceneAndEveryPair) {
  const Made made(3);
  const XmlContents xml = ReadXml(made.page);
  EXPECT_EQ(xml.error, "");
  EXPECT_EQ(xml.elements.at("article"), 15);
  EXPECT_EQ(Occurrences(made.page, "r=\"1.9\""), made.pairs);
  // Two matrices of classes, two of the thirty, two drawings of a step, two of each scene.
  EXPECT_EQ(xml.elements.at("svg"), 2 + 2 + 2 + 30);
  EXPECT_EQ(xml.links.size(), 60U);
  for (const std::string& link : xml.links) EXPECT_TRUE(xml.ids.contains(link.substr(1))) << link;
}

TEST(DofTransitionPage, NeedsNothingFromElsewhere) {
  const Made made(2);
  EXPECT_EQ(Occurrences(made.page, "src="), 0U);
  EXPECT_EQ(Occurrences(made.page, "url("), 0U);
  EXPECT_EQ(Occurrences(made.page, "href="), Occurrences(made.page, "href=\"#"));
}

// In translation one contact makes a step from (3, 0, 0) only to (2, 1, 0); a slot's walls to (2, 0, 1).
TEST(DofTransitionPage, MarksTheThirteen) {
  const Made made(1);
  EXPECT_EQ(Occurrences(made.page, "; one of the thirteen"), 13U);
  EXPECT_NE(made.page.find("3 0 0 to 2 1 0: 28 steps by one contact; one of the thirteen"),
            std::string::npos);
  EXPECT_NE(made.page.find("3 0 0 to 2 0 1: by the two walls of a slot; one of the thirteen"),
            std::string::npos);
}

}  // namespace
}  // namespace tact::provers
