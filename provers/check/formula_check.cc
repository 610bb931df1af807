// Identities between polynomials, and values at which there is none.
#include <map>

#include "provers/check/formula.h"
#include "provers/check/kinds.h"

namespace tact::check {

void CheckIdentity(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"given", "equations"});
  const auto variable = [](const std::string& name) { return Terms{{{name}, 1}}; };
  std::vector<Terms> given;
  for (const Value& zero : AsArray(At(certificate, "given"))) given.push_back(Expand(zero, variable));
  const Array& equations = AsArray(At(certificate, "equations"));
  if (equations.empty()) throw Refused(&At(certificate, "equations"), "expected an equation");
  for (const Value& equation : equations) {
    ExpectKeys(equation, {"left", "right", "cofactors"});
    Terms rest = Expand(At(equation, "left"), variable) - Expand(At(equation, "right"), variable);
    const Array& cofactors = AsArray(At(equation, "cofactors"));
    if (cofactors.size() != given.size())
      throw Refused(&At(equation, "cofactors"), "expected one for each of the given");
    for (std::size_t i = 0; i < given.size(); ++i)
      rest = rest - Multiply(Expand(cofactors[i], variable), given[i], &cofactors[i]);
    if (!rest.empty())
      throw Refused(&equation, "left less right is not the sum of cofactors times the given");
  }
}

void CheckNoIdentity(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"values", "given", "left", "right"});
  std::map<std::string, mpz_class> values;
  for (const auto& [name, value] : AsObject(At(certificate, "values"))) values[name] = AsInteger(value);
  const auto valued = [&](const Value& formula) {
    return Expand(formula, [&](const std::string& name) {
      const auto at = values.find(name);
      if (at == values.end()) throw Refused(&formula, "no value for " + Quote(name));
      return at->second == 0 ? Terms() : Terms{{{}, at->second}};
    });
  };
  for (const Value& zero : AsArray(At(certificate, "given"))) {
    if (!valued(zero).empty()) throw Refused(&zero, "is not zero");
  }
  if (valued(At(certificate, "left")) == valued(At(certificate, "right")))
    throw Refused(&At(certificate, "left"), "left and right are equal");
}

}  // namespace tact::check
