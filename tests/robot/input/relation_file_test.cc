#include "robot/input/relation_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>

namespace tact::input {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Rational;
using algebra::Vector3;

std::vector<ContactRelation> ReadAll(const std::string& text) {
  std::istringstream in(text);
  RelationStream relations(in, "t");
  std::vector<ContactRelation> all;
  while (auto relation = relations.Next()) all.push_back(std::get<ContactRelation>(std::move(*relation)));
  return all;
}

TEST(RelationFile, AContactIsAPointItsPlanesAndAName) {
  const auto all =
      ReadAll(R"({"contacts":[{"name":"tip","planes":[[0,0,1],[1,0,"-1/2"]],"point":[0.5,0,"1/3"]}]})");
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].contacts,
            (std::vector<Contact>{
                {{Rational(1, 2), 0, Rational(1, 3)}, {{0, 0, 1}, {1, 0, Rational(-1, 2)}}, "tip"}}));
}

TEST(RelationFile, NoContactsAndRepeatedContactsAreRelations) {
  EXPECT_EQ(ReadAll(R"({"contacts":[]})"), std::vector<ContactRelation>{{}});
  const std::string contact = R"({"point":[0,0,0],"planes":[[0,0,1]]})";
  EXPECT_EQ(ReadAll(R"({"contacts":[)" + contact + "," + contact + "]}").at(0).contacts.size(), 2u);
}

TEST(RelationFile, LinesAreRelationsAndBlankLinesAreNone) {
  const std::string relation = R"({"contacts":[{"point":[1,2,3],"planes":[[0,0,1]]}]})";
  const auto all = ReadAll("\n" + relation + "\r\n  \t\n" + R"({"contacts":[]})" + "\n\n" + relation);
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0], all[2]);
  EXPECT_TRUE(all[1].contacts.empty());
}

TEST(RelationFile, OneRelationMayRunOverManyLines) {
  EXPECT_EQ(ReadAll("{\n\"contacts\"\n:\n[\n]\n}\n\n").size(), 1u);
}

TEST(RelationFile, AnswersBeforeABadLineAreGiven) {
  std::istringstream in("{\"contacts\":[]}\n{\"contacts\":[]}\n{\"contacts\":5}\n");
  RelationStream relations(in, "t");
  EXPECT_TRUE(relations.Next());
  EXPECT_TRUE(relations.Next());
  EXPECT_EQ(relations.where(), "t:2:1");
  EXPECT_TRUE(relations.HasMore());
  EXPECT_THROW(relations.Next(), InputError);
}

TEST(RelationFile, TheCadFormNamesFilesBesideItAndElements) {
  std::istringstream in(
      R"({"moving":"peg.off","fixed":"/cad/hole.off","unit":"in","tolerance":"1/8",)"
      R"("pose":{"t":[1,2,3],"q":[2,0,0,0]},)"
      R"("contacts":[{"moving":{"vertex":3},"fixed":{"face":5}},{"moving":{"edge":0},"fixed":{"edge":7}}]})");
  RelationStream relations(in, "cases/peg.json");
  const auto cad = std::get<CadRelation>(*relations.Next());
  EXPECT_EQ(cad.models.moving, "cases/peg.off");
  EXPECT_EQ(cad.models.fixed, "/cad/hole.off");
  EXPECT_EQ(InMillimetres(cad.models.unit), Rational(127, 5));
  EXPECT_EQ(cad.models.tolerance, Rational(1, 8));
  EXPECT_EQ(cad.pose.pose.translation, (Vector3{1, 2, 3}));
  EXPECT_EQ(cad.pose.pose.rotation, algebra::Rotation{});
  EXPECT_EQ(cad.contacts,
            (std::vector<ElementPair>{{{algebra::ElementKind::kVertex, 3}, {algebra::ElementKind::kFace, 5}},
                                      {{algebra::ElementKind::kEdge, 0}, {algebra::ElementKind::kEdge, 7}}}));
}

TEST(RelationFile, WithoutContactsTheCadFormLeavesThemToBeFound) {
  std::istringstream in(R"({"moving":"a","fixed":"b","unit":"mm","pose":{"t":[0,0,0],"q":[1,0,0,0]}})");
  const auto cad = std::get<CadRelation>(*RelationStream(in, "<stdin>").Next());
  EXPECT_FALSE(cad.contacts.has_value());
  EXPECT_EQ(cad.models.moving, "a");
  EXPECT_EQ(cad.models.tolerance, Rational(0));
}

Rational AnyRational() {
  return Rational(algebra::Integer(static_cast<long>(*rc::gen::arbitrary<int64_t>())),
                  algebra::Integer(*rc::gen::inRange(1, 1000)));
}

std::string Print(const Vector3& v) {
  return "[\"" + v.x.ToString() + "\",\"" + v.y.ToString() + "\",\"" + v.z.ToString() + "\"]";
}

std::string Print(const ContactRelation& relation) {
  std::string text;
  for (const Contact& contact : relation.contacts) {
    std::string planes;
    for (const Vector3& plane : contact.planes) planes += (planes.empty() ? "" : ", ") + Print(plane);
    text += (text.empty() ? "" : ",") + std::string("{\"point\":") + Print(contact.point) + ",\"planes\":[" +
            planes + "],\"name\":\"" + contact.name + "\"}";
  }
  return "{\"contacts\":[" + text + "]}";
}

RC_GTEST_PROP(RelationLaw, PrintAndParse, ()) {
  std::vector<ContactRelation> relations(*rc::gen::inRange<size_t>(1, 4));
  std::string text;
  for (ContactRelation& relation : relations) {
    relation.contacts.resize(*rc::gen::inRange<size_t>(0, 4));
    for (Contact& contact : relation.contacts) {
      contact.point = {AnyRational(), AnyRational(), AnyRational()};
      contact.planes.resize(*rc::gen::inRange<size_t>(1, 4));
      for (Vector3& plane : contact.planes) plane = {AnyRational(), AnyRational(), 1};
      contact.name = *rc::gen::elementOf(std::vector<std::string>{"", "corner 1", "Öse"});
    }
    text += Print(relation) + "\n";
  }
  RC_ASSERT(ReadAll(text) == relations);
}

}  // namespace
}  // namespace tact::input
