/// @file
/// What one contact primitive of a CAD model adds to a contact relation: contacts that come together.
/// Model   Contacts with one normal may slide along their lines of action into one plane square to it, which changes no
///         motion: two of them are the ends of an edge, three or four in convex position the corners of a face. No
///         corner lies in the hull of the others, so none is idle.
#pragma once

#include <string>
#include <vector>

#include "enumerators/contact_world.h"

namespace tact::enumerators {

enum class AdditionKind { kContact, kEdge, kFace };
constexpr size_t kAdditionKinds = 3;

/// "contact", "edge", "face".
std::string ToString(AdditionKind kind);

struct Addition {
  AdditionKind kind = AdditionKind::kContact;
  std::vector<size_t> contacts;  // indices of the world's contacts, increasing
};

/// All of the world's, by kind, then in canonical order (contact_sets.h). Precondition: no singular contact.
std::vector<Addition> Additions(const ContactWorld& world);

}  // namespace tact::enumerators
