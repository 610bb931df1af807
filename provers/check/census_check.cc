// A census: every class of motion DOFs in a finite world with its number of members and a witness.
#include <map>
#include <string>

#include "provers/check/kinds.h"

namespace tact::check {

void CheckCensus(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"world", "count", "classes"}, {"asserts"});
  AsString(At(certificate, "world"));
  const Value& count = At(certificate, "count");
  const Array& classes = AsArray(At(certificate, "classes"));
  if (classes.empty()) throw Refused(&At(certificate, "classes"), "no class");

  mpz_class members = 0;
  std::map<MotionNumbers, std::size_t> first_with;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ExpectKeys(classes[i], {"count", "relation"});
    const Value& own = At(classes[i], "count");
    const mpz_class own_members = AsInteger(own);
    if (own_members <= 0) throw Refused(&own, "a class has at least one member, its witness");
    members += own_members;

    const MotionNumbers dof = CheckRelation(At(classes[i], "relation"));
    const auto [same, is_new] = first_with.emplace(dof, i);
    if (!is_new) throw Refused(&classes[i], "has the motion DOFs of class " + std::to_string(same->second));
    if (const Value* asserts = Find(certificate, "asserts")) {
      try {
        CheckAsserts(*asserts, dof);
      } catch (const Refused& refused) {
        throw Refused(refused.where(), "in class " + std::to_string(i) + ": " + refused.what());
      }
    }
  }
  if (AsInteger(count) != members)
    throw Refused(&count, "the classes have " + Quote(members.get_str()) + " members");
}

}  // namespace tact::check
