#include "enumerators/dof_counts_text.h"

#include <gtest/gtest.h>

#include "algebra/error.h"
#include "enumerators/dof_class.h"

namespace tact::enumerators {
namespace {

TEST(DofCountsText, IsReadBackAsItWas) {
  const DofCounts counts = DofCensus(CornerWorld(5)).Count();
  ASSERT_GT(counts.size(), 40U);
  EXPECT_EQ(ParseDofCounts(ToText(counts)), counts);
  EXPECT_EQ(ParseDofCounts(ToText({})), DofCounts{});
}

TEST(DofCountsText, EveryClassKeepsAllItsIndices) {
  DofCounts counts;
  for (const algebra::MotionDof& dof : DofClasses()) counts.push_back({dof, uint64_t{1} << 63, {0, 7, 300}});
  EXPECT_EQ(ParseDofCounts(ToText(counts)), counts);
}

TEST(DofCountsText, AnythingElseIsRefusedWithThePlace) {
  const std::string text = ToText(DofCensus(CornerWorld(1)).Count());
  for (size_t i = 0; i < text.size(); ++i) EXPECT_THROW(ParseDofCounts(text.substr(0, i)), InputError) << i;
  EXPECT_THROW(ParseDofCounts(text + " "), InputError);
  const auto changed = [&](const std::string& from, const std::string& to) {
    std::string other = text;
    other.replace(other.find(from), from.size(), to);
    return other;
  };
  const size_t line = text.find('\n', 2);
  const std::vector<std::string> wrong = {
      changed("[2,1,0,", "[2,1,"),               // nine indices
      changed("\"count\":28", "\"count\":-28"),  // no count
      changed("\"count\":28", "\"count\":99999999999999999999"),
      changed("witness", "wildness"),
      text.substr(0, line) + text.substr(1, line - 1) + "]",  // a class twice
  };
  for (const std::string& other : wrong) EXPECT_THROW(ParseDofCounts(other), InputError) << other;
  try {
    ParseDofCounts(changed("witness", "wildness"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("wildness"), std::string::npos) << error.what();
  }
}

TEST(DofCountsText, TheDescriptionTellsCensusesApart) {
  const auto describe = [](const ContactWorld& world) {
    return DescribeCensus(DofCensus(world), "corner", "1");
  };
  EXPECT_EQ(describe(CornerWorld(3)), describe(CornerWorld(3)));
  EXPECT_NE(describe(CornerWorld(3)), describe(CornerWorld(4)));
  ContactWorld other = CornerWorld(3);
  other.contacts[5].point = other.contacts[5].point + algebra::Vector3{5, 6, 7};
  EXPECT_NE(describe(other), describe(CornerWorld(3)));
  EXPECT_NE(DescribeCensus(DofCensus(CornerWorld(3)), "corner", "2"), describe(CornerWorld(3)));
}

}  // namespace
}  // namespace tact::enumerators
