#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }

TEST(CertificateCheck, AnotherFormatVersionOrKindIsRefused) {
  json certificate = brute::Certificate("basis");
  certificate["kind"] = "theorem";
  EXPECT_EQ(Why(certificate), "kind: this checker knows no kind \"theorem\"");
  certificate["version"] = 2;
  EXPECT_EQ(Why(certificate), "version: this checker knows version 1 only");
  certificate["format"] = "tact";
  EXPECT_EQ(Why(certificate), "format: expected \"tact-certificate\"");
  EXPECT_EQ(Why(json::array()), "expected an object, got a list");
}

TEST(CertificateCheck, TheClaimIsReadEvenIfTheRestIsRefused) {
  json certificate = brute::Certificate("basis");
  certificate["translations"] = 3;
  const Answer answer = CheckCertificate(certificate.dump());
  EXPECT_FALSE(answer.accepted);
  EXPECT_EQ(answer.claim, "example.basis");
  certificate["claim"] = "";
  EXPECT_EQ(Why(certificate), "claim: names no claim");
}

TEST(CensusCheck, AClassTwiceIsRefused) {
  json census = brute::Certificate("census");
  census["classes"].push_back(census["classes"][1]);
  census["count"] = 11;
  EXPECT_EQ(Why(census), "classes[4]: has the motion DOFs of class 1");
}

TEST(CensusCheck, AnAssertThatFailsInOneClassNamesTheClass) {
  json census = brute::Certificate("census");
  census["asserts"] = {{{"sum", {{"rotation.constraining", 1}}}, {"is", "zero"}}};
  EXPECT_EQ(Why(census), "asserts[0]: in class 3: does not hold: the sum is \"1\"");
}

TEST(CensusCheck, ACensusWithoutClassesIsRefused) {
  json census = brute::Certificate("census");
  census["classes"] = json::array();
  census["count"] = 0;
  EXPECT_EQ(Why(census), "classes: no class");
}

TEST(TransitionCheck, ListsInAnotherOrderOrIncompleteAreRefused) {
  const json original = brute::Certificate("transitions");
  json certificate = original;
  std::swap(certificate["transitions"][2]["dof_transitions"][0],
            certificate["transitions"][2]["dof_transitions"][1]);
  EXPECT_EQ(Why(certificate),
            "transitions[2].dof_transitions[0]: the motion DOFs show, in translation, maintaining -> "
            "singular_maintaining");
  certificate = original;
  certificate["transitions"][2]["dof_transitions"].erase(0);
  EXPECT_FALSE(Why(certificate).empty());
  certificate = original;
  certificate["transitions"][2]["dof_transitions"].erase(5);
  EXPECT_EQ(Why(certificate), "transitions[2].dof_transitions: the motion DOFs show 6, not 5");
  certificate = original;
  certificate["transitions"][0]["dof_transitions"].push_back(
      certificate["transitions"][2]["dof_transitions"][0]);
  EXPECT_EQ(Why(certificate), "transitions[0].dof_transitions[2]: the motion DOFs show no more than 2");
  certificate = original;
  certificate["transitions"][1]["sub_skills"].push_back("slide-in-rotation");
  EXPECT_EQ(Why(certificate),
            "transitions[1].sub_skills: the motion DOFs show detach-contact-in-translation, "
            "detach-contact-in-rotation");
  certificate = original;
  certificate["transitions"][0]["to"] = 5;
  EXPECT_EQ(Why(certificate), "transitions[0].to: expected an index from 0 to 5 exclusive");
}

TEST(TransitionCheck, FewerOrMoreNamesThanRelationsAreRefused) {
  json certificate = brute::Certificate("transitions");
  certificate["names"].push_back("another");
  EXPECT_EQ(Why(certificate), "names: expected one name a relation");
}

TEST(BasisCheck, AnotherSpaceIsRefusedThoughItsNumbersFit) {
  json certificate = brute::Certificate("basis");
  certificate["reduced"][2] = {1, 0, 0, 0, 0, 3};
  EXPECT_EQ(Why(certificate), "reduced: spans another space than the vectors");
  certificate = brute::Certificate("basis");
  certificate["reduced"][1] = {0, 0, 1, 1, 0, 0};  // the same space, but two vectors turn about one axis
  certificate["translations"] = 0;
  EXPECT_EQ(Why(certificate), "reduced: the angular parts that are not zero are linearly dependent");
}

TEST(IllReducedCheck, AMotionForbiddenAtAnEndOrAdmittedBetweenIsRefused) {
  json certificate = brute::Certificate("ill_reduced_edges");
  certificate["motion"][5] = -2;
  EXPECT_EQ(Why(certificate), "ends[0]: the motion is forbidden at this end already");
  certificate["motion"][5] = 0;
  EXPECT_EQ(Why(certificate), "planes[0]: the plane admits the motion between the ends");
}

}  // namespace
}  // namespace tact::check
