#include "provers/claims/dof_laws.h"

namespace tact::provers {
namespace {

// The index of each of the three kinds of motion and how many degrees of freedom it has.
const std::pair<const char*, int> kMotions[] = {{"translation.", 3}, {"rotation.", 3}, {"all.", 6}};

}  // namespace

std::vector<Assertion> SumLaws() {
  std::vector<Assertion> laws;
  for (const auto& [name, freedom] : kMotions) {
    const std::string motion = name;
    laws.push_back({{{motion + "maintaining", 1},
                     {motion + "detaching", 1},
                     {motion + "constraining", 1},
                     {"constant", -freedom}},
                    "zero"});
    laws.push_back({{{motion + "detaching", 1}}, "nonnegative"});
  }
  return laws;
}

std::vector<Assertion> RestrictedLaws(const std::string& is) {
  std::vector<Assertion> laws;
  for (const auto& [name, freedom] : kMotions) {
    const std::string motion = name;
    laws.push_back(
        {{{motion + "restricted", 1}, {motion + "detaching", -1}, {motion + "constraining", -1}}, is});
  }
  return laws;
}

}  // namespace tact::provers
