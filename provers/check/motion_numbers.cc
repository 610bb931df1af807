#include "provers/check/motion_numbers.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tact::check {
namespace {

bool Holds(int sign, const Value& is) {
  const std::string& word = AsString(is);
  if (word == "zero") return sign == 0;
  if (word == "nonzero") return sign != 0;
  if (word == "negative") return sign < 0;
  if (word == "positive") return sign > 0;
  if (word == "nonnegative") return sign >= 0;
  throw Refused(&is, "expected zero, nonzero, negative, positive or nonnegative, got " + Quote(word));
}

}  // namespace

std::size_t IndexOf(std::string_view name) {
  return static_cast<std::size_t>(std::find(kIndexNames.begin(), kIndexNames.end(), name) -
                                  kIndexNames.begin());
}

int& MotionNumbers::operator[](std::string_view name) { return values.at(IndexOf(name)); }

MotionNumbers FromRanks(const Ranks& ranks) {
  MotionNumbers dof;
  dof.singular = ranks.singular;
  dof["all.maintaining"] = 6 - ranks.a;
  dof["all.constraining"] = ranks.a_in_all;
  dof["all.detaching"] = ranks.a - ranks.a_in_all;
  dof["translation.maintaining"] = 3 - ranks.n;
  dof["translation.constraining"] = ranks.n_in_translation;
  dof["translation.detaching"] = ranks.n - ranks.n_in_translation;
  const int maintaining = dof["rotation.maintaining"] = 3 - (ranks.a - ranks.n);
  const int constraining = dof["rotation.constraining"] = ranks.a_in_all - ranks.n_in_all;
  const int detaching = dof["rotation.detaching"] = 3 - maintaining - constraining;
  const int type1 = dof["rotation.detaching_type1"] =
      3 - (ranks.a_in_translation - ranks.n_in_translation) - maintaining;
  dof["rotation.detaching_type2"] = detaching - type1;
  dof["all.restricted"] = ranks.planes;
  dof["translation.restricted"] = ranks.plane_forces;
  dof["rotation.restricted"] = ranks.planes - ranks.plane_forces;
  return dof;
}

void ExpectNumbers(const Value& dof, const MotionNumbers& numbers) {
  ExpectKeys(dof, {"singular", "translation", "rotation", "all"});
  ExpectKeys(At(dof, "translation"), {"maintaining", "detaching", "constraining", "restricted"});
  ExpectKeys(At(dof, "rotation"), {"maintaining", "detaching", "detaching_type1", "detaching_type2",
                                   "constraining", "restricted"});
  ExpectKeys(At(dof, "all"), {"maintaining", "detaching", "constraining", "restricted"});
  const Value& singular = At(dof, "singular");
  if (AsBool(singular) != numbers.singular) {
    throw Refused(&singular,
                  numbers.singular ? "a contact has several planes" : "no contact has several planes");
  }
  for (std::size_t i = 0; i < kIndexNames.size(); ++i) {
    const std::size_t dot = kIndexNames[i].find('.');
    const Value& value = At(At(dof, kIndexNames[i].substr(0, dot)), kIndexNames[i].substr(dot + 1));
    if (AsInteger(value) != numbers.values[i]) {
      throw Refused(&value, "the evidence shows " + std::to_string(numbers.values[i]));
    }
  }
}

void CheckAsserts(const Value& asserts, const MotionNumbers& numbers) {
  for (const Value& assertion : AsArray(asserts)) {
    ExpectKeys(assertion, {"sum", "is"});
    mpz_class sum = 0;
    for (const auto& [name, coefficient] : AsObject(At(assertion, "sum"))) {
      const std::size_t index = IndexOf(name);
      if (index == kIndexNames.size() && name != "constant") {
        throw Refused(&coefficient, "no index is named " + Quote(name));
      }
      sum += AsInteger(coefficient) * (name == "constant" ? 1 : numbers.values[index]);
    }
    if (!Holds(sgn(sum), At(assertion, "is"))) {
      throw Refused(&assertion, "does not hold: the sum is " + Quote(sum.get_str()));
    }
  }
}

}  // namespace tact::check
