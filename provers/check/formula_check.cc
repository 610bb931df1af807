// Identities between polynomials, and values at which there is none.
#include <map>

#include "provers/check/formula.h"
#include "provers/check/kinds.h"

namespace tact::check {

void CheckIdentity(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"given", "equations"});
  Expander expander([](const std::string& name) { return Terms{{{name}, 1}}; });
  std::vector<Terms> given;
  for (const Value& zero : AsArray(At(certificate, "given"))) given.push_back(expander.Expand(zero));
  const Array& equations = AsArray(At(certificate, "equations"));
  if (equations.empty()) throw Refused(&At(certificate, "equations"), "expected an equation");
  for (const Value& equation : equations) {
    ExpectKeys(equation, {"left", "right", "cofactors"});
    Terms rest = expander.Expand(At(equation, "left"));
    Add(rest, expander.Expand(At(equation, "right")), -1);
    const Array& cofactors = AsArray(At(equation, "cofactors"));
    if (cofactors.size() != given.size())
      throw Refused(&At(equation, "cofactors"), "expected one for each of the given");
    for (std::size_t i = 0; i < given.size(); ++i)
      Add(rest, expander.Multiply(expander.Expand(cofactors[i]), given[i], &cofactors[i]), -1);
    if (!rest.empty())
      throw Refused(&equation, "left less right is not the sum of cofactors times the given");
  }
}

void CheckNoIdentity(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"values", "given", "left", "right"});
  std::map<std::string, mpz_class> values;
  for (const auto& [name, value] : AsObject(At(certificate, "values"))) values[name] = AsInteger(value);
  std::string unknown;
  Expander expander([&](const std::string& name) {
    const auto at = values.find(name);
    if (at == values.end()) unknown = name;
    return at == values.end() || at->second == 0 ? Terms() : Terms{{{}, at->second}};
  });
  const auto valued = [&](const Value& formula) {
    Terms number = expander.Expand(formula);
    if (!unknown.empty()) throw Refused(&formula, "no value for " + Quote(unknown));
    return number;
  };
  for (const Value& zero : AsArray(At(certificate, "given"))) {
    if (!valued(zero).empty()) throw Refused(&zero, "is not zero");
  }
  if (valued(At(certificate, "left")) == valued(At(certificate, "right")))
    throw Refused(&At(certificate, "left"), "left and right are equal");
}

}  // namespace tact::check
