#include "enumerators/dof_class_list.h"

#include <map>

#include "algebra/error.h"

namespace tact::enumerators {

std::vector<DofClassList> ListDofClasses(const DofCounts& counts) {
  for (const DofCount& c : counts) {
    if (const auto lemma = ExcludingLemma(c.dof))
      throw InvariantError("a relation that breaks the lemma " + DofLemmas()[*lemma].id);
  }
  std::vector<DofClassList> lists;
  for (const DofDefinition& definition : DofDefinitions()) {
    std::map<std::vector<int>, FoundClass> classes;
    for (const DofCount& c : counts) {
      const std::vector<int> values = IndexValues(c.dof, definition);
      FoundClass& found = classes.try_emplace(values, FoundClass{values, 0, c.witness}).first->second;
      found.count += c.count;
      if (ComesBefore(c.witness, found.witness)) found.witness = c.witness;
    }
    DofClassList list{&definition, {}, CountDistinct(DofClasses(), definition)};
    for (auto& [values, found] : classes) list.found.push_back(std::move(found));
    lists.push_back(std::move(list));
  }
  return lists;
}

bool IsBoxWorld(const ContactWorld& world) {
  for (const algebra::Contact& contact : world.contacts) {
    for (const algebra::Vector3& n : contact.planes) {
      if ((n.x.sign() != 0) + (n.y.sign() != 0) + (n.z.sign() != 0) != 1) return false;
    }
  }
  return true;
}

}  // namespace tact::enumerators
