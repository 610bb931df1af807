// A census: every class of motion DOFs in a finite world with its number of members and a witness.
#include <map>
#include <set>
#include <string>

#include "provers/check/kinds.h"
#include "provers/check/recount.h"

namespace tact::check {
namespace {

struct Class {
  mpz_class members;
  std::size_t place;
};

struct World {
  std::vector<ContactNumbers> contacts;
  std::size_t largest = 0;
};

World ReadGenerator(const Value& generator) {
  ExpectKeys(generator, {"contacts", "largest"});
  World world;
  world.largest = AsIndex(At(generator, "largest"), kMaxGeneratorLargest + 1);
  std::set<ContactNumbers> seen;
  for (const Value& contact : AsArray(At(generator, "contacts"))) {
    world.contacts.push_back(ReadContact(contact));
    if (!seen.insert(world.contacts.back()).second) throw Refused(&contact, "stands twice");
  }
  return world;
}

void ExpectWitnesses(const World& world, const Array& classes) {
  const std::set<ContactNumbers> known(world.contacts.begin(), world.contacts.end());
  for (const Value& one : classes) {
    const Value& list = At(At(one, "relation"), "contacts");
    if (AsArray(list).size() > world.largest) {
      throw Refused(
          &list, "the generator makes relations of at most " + std::to_string(world.largest) + " contacts");
    }
    for (const Value& contact : AsArray(list)) {
      if (!known.contains(ReadContact(contact)))
        throw Refused(&contact, "is none of the generator's contacts");
    }
  }
}

// Why the members of the classes are not counted again; empty if they are to be.
std::string ReasonNotToRecount(const World& world, const mpz_class& count) {
  if (count > kMaxRecount) return "it has more than " + std::to_string(kMaxRecount) + " relations";
  if (world.largest > kMaxRecountLargest)
    return "its relations have more than " + std::to_string(kMaxRecountLargest) + " contacts";
  for (const ContactNumbers& contact : world.contacts) {
    if (contact.planes.size() > kMaxRecountPlanes)
      return "a contact has more than " + std::to_string(kMaxRecountPlanes) + " planes";
  }
  return "";
}

std::string CheckWorld(const Value& certificate, const std::map<MotionNumbers, Class>& claimed) {
  const Value* generator = Find(certificate, "generator");
  if (generator == nullptr) return "it has no generator";
  const World world = ReadGenerator(*generator);
  const mpz_class relations = MultisetCount(world.contacts.size(), world.largest);
  const Value& count = At(certificate, "count");
  if (AsInteger(count) != relations)
    throw Refused(&count, "the generator makes " + Quote(relations.get_str()) + " relations");
  const Array& classes = AsArray(At(certificate, "classes"));
  ExpectWitnesses(world, classes);

  const std::string reason = ReasonNotToRecount(world, relations);
  if (!reason.empty()) return reason;
  const auto counted = Recount(world.contacts, world.largest);
  if (!counted) return "its numbers leave 64 bits";
  for (const auto& [dof, one] : claimed) {
    const auto found = counted->find(dof);
    const std::size_t members = found == counted->end() ? 0 : found->second;
    if (one.members != members) {
      throw Refused(&At(classes[one.place], "count"),
                    "the world has " + std::to_string(members) + " such relations");
    }
  }
  return "";
}

}  // namespace

std::string CheckCensus(const Value& certificate) {
  ExpectCertificateKeys(certificate, {"world", "count", "classes"}, {"generator", "asserts"});
  AsString(At(certificate, "world"));
  const Value& count = At(certificate, "count");
  const Array& classes = AsArray(At(certificate, "classes"));
  if (classes.empty()) throw Refused(&At(certificate, "classes"), "no class");

  mpz_class members = 0;
  std::map<MotionNumbers, Class> by_dof;
  for (std::size_t i = 0; i < classes.size(); ++i) {
    ExpectKeys(classes[i], {"count", "relation"});
    const Value& own = At(classes[i], "count");
    const mpz_class own_members = AsInteger(own);
    if (own_members <= 0) throw Refused(&own, "a class has at least one member, its witness");
    members += own_members;

    const MotionNumbers dof = CheckRelation(At(classes[i], "relation"));
    const auto [same, is_new] = by_dof.emplace(dof, Class{own_members, i});
    if (!is_new) {
      throw Refused(&classes[i], "has the motion DOFs of class " + std::to_string(same->second.place));
    }
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
  return CheckWorld(certificate, by_dof);
}

}  // namespace tact::check
