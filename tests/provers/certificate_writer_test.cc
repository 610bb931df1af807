// Twin: what the engines write, the checker, which shares no code with them, accepts.
#include "provers/certificate_writer.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "provers/check/check.h"

namespace tact::provers {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Rational;
using algebra::Vector3;

rc::Gen<Vector3> AnyVector(int bound, bool nonzero) {
  const auto entry = rc::gen::inRange(-bound, bound + 1);
  const auto denominator = rc::gen::element(1, 1, 1, 2, 3);
  const auto vector = rc::gen::map(rc::gen::tuple(entry, entry, entry, denominator), [](const auto& t) {
    const auto [x, y, z, d] = t;
    return Vector3{Rational(x, d), Rational(y, d), Rational(z, d)};
  });
  return rc::gen::suchThat(vector, [nonzero](const Vector3& v) { return !nonzero || !v.IsZero(); });
}

// Entries are small and every third contact opposes an earlier one along its line of force, so that dependent rows
// and implicit equalities are common.
ContactRelation AnyRelation() {
  ContactRelation relation;
  const int size = *rc::gen::inRange(0, 9);
  for (int i = 0; i < size; ++i) {
    Contact contact{*AnyVector(2, false), {*AnyVector(1, true)}, ""};
    if (*rc::gen::inRange(0, 6) == 0) contact.planes.push_back(*AnyVector(1, true));
    if (i > 0 && *rc::gen::inRange(0, 3) == 0) {
      const Contact& earlier = relation.contacts[*rc::gen::inRange(0, i)];
      contact.planes = {Rational(*rc::gen::inRange(1, 4)) * -earlier.planes[0]};
      contact.point = earlier.point + Rational(*rc::gen::inRange(0, 3), 2) * earlier.planes[0];
    }
    relation.contacts.push_back(contact);
  }
  return relation;
}

std::string WhyRefused(const Certificate& certificate) {
  return check::CheckCertificate(certificate.json).why;
}

RC_GTEST_PROP(CertificateWriterTwin, MotionDofsOfRandomRelationsAreAccepted, ()) {
  const ContactRelation relation = AnyRelation();
  const Assertion types{
      {{"rotation.detaching_type1", 1}, {"rotation.detaching_type2", 1}, {"rotation.detaching", -1}}, "zero"};
  RC_ASSERT(WhyRefused(MotionDofCertificate("x", "claim", relation, {types})) == "");
}

RC_GTEST_PROP(CertificateWriterTwin, TransitionsBetweenRandomRelationsAreAccepted, ()) {
  const std::vector<std::pair<std::string, ContactRelation>> relations = {
      {"a", AnyRelation()}, {"b", AnyRelation()}, {"c", AnyRelation()}};
  RC_ASSERT(WhyRefused(TransitionsCertificate("x", "claim", relations, {})) == "");
}

TEST(CertificateWriterTwin, CensusBasisAndIllReducedEdgeAreAccepted) {
  const Contact floor{{Rational(1, 2), 0, 0}, {{0, 0, 1}}, "floor"};
  const ContactRelation free{}, on_floor{{floor}};
  const std::vector<CensusClass> classes = {{ComputeMotionDof(free), 1, free},
                                            {ComputeMotionDof(on_floor), 3, on_floor}};
  EXPECT_EQ(WhyRefused(CensusCertificate("x", "claim", {"", {floor}, 3}, classes, {})), "");
  EXPECT_EQ(WhyRefused(CensusCertificate("x", "claim", {"", {floor}, 4}, classes, {})),
            "count: the classes have \"4\" members");
  EXPECT_EQ(WhyRefused(BasisCertificate("x", "claim", {{0, 0, 1, 0, 0, 0}, {0, 0, 1, 1, 0, 0}},
                                        {{0, 0, 1, 0, 0, 0}, {0, 0, 0, 1, 0, 0}}, 1)),
            "");
  IllReducedEdge edge{{-1, 0, 0}, {1, 0, 0}, {{0, 1, 1}, {0, -1, 1}}, {0, 0, 1, 0, 0, -1}};
  EXPECT_EQ(WhyRefused(IllReducedEdgeCertificate("x", "claim", edge)), "");
  edge.motion[2] = 0;
  EXPECT_NE(WhyRefused(IllReducedEdgeCertificate("x", "claim", edge)), "");
}

}  // namespace
}  // namespace tact::provers
