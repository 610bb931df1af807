#include "robot/input/demonstration.h"

#include <gtest/gtest.h>

#include <sstream>

namespace tact::input {
namespace {

Demonstration Read(const std::string& text) {
  std::istringstream in(text);
  return ReadDemonstration(in, "demos/peg.json");
}

constexpr const char* kContact = R"("contacts":[{"point":[0,0,0],"planes":[[0,0,1]]}])";

TEST(Demonstration, StatesArePosesOfTheMovingSolid) {
  const auto demonstration = std::get<PoseDemonstration>(Read(
      R"({"moving":"peg.off","fixed":"slot.off","unit":"mm","tolerance":0.5,
 "states":[{"name":"A","pose":{"t":[0,0,9],"q":[1,0,0,0]}},
           {"pose":{"t":[0,0,5],"axis":[0,0,1],"angle":0.1}}]})"));
  EXPECT_EQ(demonstration.models.moving, "demos/peg.off");
  EXPECT_EQ(demonstration.models.tolerance, algebra::Rational(1, 2));
  ASSERT_EQ(demonstration.states.size(), 2u);
  EXPECT_EQ(demonstration.states[0].name, "A");
  EXPECT_EQ(demonstration.states[1].name, "2");
  EXPECT_EQ(demonstration.states[1].where, "demos/peg.json:3:12");
  EXPECT_TRUE(demonstration.states[0].pose.exact);
  EXPECT_FALSE(demonstration.states[1].pose.exact);
}

TEST(Demonstration, RelationsInOneObjectAndOneALineAreTheSame) {
  const std::string named = std::string(R"({"name":"A",)") + kContact + "}";
  const std::string unnamed = std::string("{") + kContact + "}";
  const auto object =
      std::get<RelationDemonstration>(Read("{\"relations\":[\n" + named + ",\n" + unnamed + "]}"));
  const auto lines = std::get<RelationDemonstration>(Read(named + "\n\n" + unnamed + "\n"));
  ASSERT_EQ(object.relations.size(), 2u);
  EXPECT_EQ(object.relations[0].name, "A");
  EXPECT_EQ(object.relations[1].name, "2");
  EXPECT_EQ(object.relations[1].relation.contacts.size(), 1u);
  EXPECT_EQ(lines.relations, object.relations);
}

}  // namespace
}  // namespace tact::input
