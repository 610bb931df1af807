#include <gtest/gtest.h>

#include "provers/check/check.h"
#include "provers/check/formula.h"
#include "tests/check/brute.h"

namespace tact::check {
namespace {

using brute::json;

std::string Why(const json& certificate) { return CheckCertificate(certificate.dump()).why; }
bool Accepts(const json& certificate) { return CheckCertificate(certificate.dump()).accepted; }

json Head(const char* kind) {
  return {{"format", "tact-certificate"}, {"version", 1}, {"claim", "example.formula"}, {"kind", kind}};
}

json Identity(const std::string& left, const std::string& right) {
  json certificate = Head("identity");
  certificate["given"] = json::array();
  certificate["equations"] = {{{"left", left}, {"right", right}, {"cofactors", json::array()}}};
  return certificate;
}

TEST(FormulaCheck, SchoolbookIdentitiesAreAccepted) {
  for (const auto& [left, right] :
       {std::pair("(a+b)^2", "a^2 + 2*a*b + b^2"), std::pair("(a-b)*(a+b)", "a^2-b^2"),
        std::pair("-a^2", "-(a*a)"), std::pair("a - b - c", "a - (b + c)"), std::pair("--a", "a"),
        std::pair("a^0", "1"), std::pair("2*3+4", "10"), std::pair("x1*x10", "x10*x1"), std::pair("0*a", "0"),
        // Euler's four squares, as products of quaternions' norms.
        std::pair("(a^2+b^2+c^2+d^2)*(p^2+q^2+r^2+s^2)",
                  "(a*p-b*q-c*r-d*s)^2+(a*q+b*p+c*s-d*r)^2+(a*r-b*s+c*p+d*q)^2+(a*s+b*r-c*q+d*p)^2")})
    EXPECT_TRUE(Accepts(Identity(left, right)))
        << left << " = " << right << ": " << Why(Identity(left, right));
}

TEST(FormulaCheck, FalseOnesAreRefused) {
  for (const auto& [left, right] :
       {std::pair("(a+b)^2", "a^2 + b^2"), std::pair("a*b", "a*c"), std::pair("a^2", "a^3"),
        std::pair("-a^2", "(-a)^2"), std::pair("a-b-c", "a-(b-c)"), std::pair("x1", "x10")})
    EXPECT_EQ(Why(Identity(left, right)),
              "equations[0]: left less right is not the sum of cofactors times the given")
        << left;
}

TEST(FormulaCheck, WhatIsNoFormulaIsRefusedWithItsPlace) {
  EXPECT_EQ(Why(Identity("a+", "a")), "equations[0].left: expected a number, a name or ( at character 3");
  EXPECT_EQ(Why(Identity("(a", "a")), "equations[0].left: expected ) at character 3");
  EXPECT_EQ(Why(Identity("a b", "a")), "equations[0].left: expected an operator at character 3");
  EXPECT_EQ(Why(Identity("a/2", "a")), "equations[0].left: expected an operator at character 2");
  EXPECT_EQ(Why(Identity("a^b", "a")),
            "equations[0].left: expected an exponent of one or two digits at character 3");
  EXPECT_EQ(Why(Identity("a^17", "a")), "equations[0].left: the exponent is beyond 16 at character 5");
  EXPECT_NE(Why(Identity("", "a")), "");
}

TEST(FormulaCheck, HostileFormulasAreRefusedNotRun) {
  EXPECT_NE(Why(Identity(std::string(100000, '('), "a")), "");
  EXPECT_NE(Why(Identity(std::string(100000, '-') + "a", "a")), "");
  EXPECT_EQ(Why(Identity("((((a+b+c+d+e+f)^16)^16)^16)^16", "a")), "equations[0].left: too many terms");
  for (const char* base : {"a", "9"}) {
    std::string power = base;
    for (int i = 0; i < 50; ++i) power = "(" + power + ")^16";
    EXPECT_EQ(Why(Identity(power, "a")), "equations[0].left: too high a degree or too large a number");
  }
}

TEST(FormulaCheck, ConsequencesOfWhatIsGivenNeedTheirCofactors) {
  json certificate = Head("identity");
  certificate["given"] = {"c^2+s^2-1"};
  certificate["equations"] = {{{"left", "c^4"}, {"right", "(1-s^2)^2"}, {"cofactors", {"c^2+1-s^2"}}}};
  EXPECT_TRUE(Accepts(certificate)) << Why(certificate);
  for (const char* wrong : {"c^2", "0", "c^2+1+s^2", "2*c^2+1-s^2"}) {
    certificate["equations"][0]["cofactors"] = {wrong};
    EXPECT_FALSE(Accepts(certificate)) << wrong;
  }
  certificate["equations"][0]["cofactors"] = json::array();
  EXPECT_EQ(Why(certificate), "equations[0].cofactors: expected one for each of the given");
  certificate["equations"] = json::array();
  EXPECT_EQ(Why(certificate), "equations: expected an equation");
}

TEST(FormulaCheck, ARefutationNeedsValuesThatFit) {
  json certificate = Head("no-identity");
  certificate["values"] = {{"c", 0}, {"s", 1}};
  certificate["given"] = {"c^2+s^2-1"};
  certificate["left"] = "c";
  certificate["right"] = "s";
  EXPECT_TRUE(Accepts(certificate)) << Why(certificate);
  json changed = certificate;
  changed["values"]["s"] = 2;
  EXPECT_EQ(Why(changed), "given[0]: is not zero");
  changed = certificate;
  changed["right"] = "c*s";
  EXPECT_EQ(Why(changed), "left: left and right are equal");
  changed = certificate;
  changed["left"] = "t";
  EXPECT_EQ(Why(changed), "left: no value for \"t\"");
  changed = certificate;
  changed["extra"] = 1;
  EXPECT_FALSE(Accepts(changed));
}

}  // namespace
}  // namespace tact::check
