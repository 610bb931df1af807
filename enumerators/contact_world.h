/// @file
/// Finite worlds of contact relations: every multiset of up to so many contacts from a list, once, in canonical order.
/// Model   A relation is a nondecreasing sequence of indices into `contacts`; shorter relations come first, then
///         lexicographic order. Contacts with the same row [ p x n | n ] count as one: sliding a contact along
///         its line of action changes nothing.
/// Cost    The walk changes one relation in place and allocates nothing but its first growth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algebra/contact/contact_relation.h"

namespace tact::enumerators {

struct ContactWorld {
  std::string sentence;  // what is in it, for people
  std::vector<algebra::Contact> contacts;
  size_t largest = 0;  // contacts in a relation, at most
};

/// Points of {-1, 0, 1}^3, normals along the axes: 54 contacts.
ContactWorld AxisWorld(size_t largest);
/// Points of {-1, 0, 1}^3, normals with entries -1, 0, 1.
ContactWorld DiagonalWorld(size_t largest);
/// Points of {0, 1}^3, normals along the axes: 24 contacts, the solids being boxes.
ContactWorld CubeWorld(size_t largest);
/// The axis contacts through 0, x, y, z, those with normals (1, 1, 0) and (-1, -1, 0) there and two more,
/// chosen so that every DOF class has a relation with the fewest contacts possible among its sets of 7.
ContactWorld CornerWorld(size_t largest);
/// The axis contacts through the origin's neighbours 0, x, y, z, and singular ones with two axis normals there.
ContactWorld SingularWorld(size_t largest);

/// "corner", "cube", "axis", "diagonal": the worlds a user can name.
std::vector<std::string> WorldNames();
/// PreconditionError: no world of that name.
ContactWorld NamedWorld(const std::string& name, size_t largest);

/// How many relations the world has.
size_t Count(const ContactWorld& world);

/// Visits every relation once, in order; the reference is valid during the call only.
void ForEachRelation(const ContactWorld& world,
                     const std::function<void(const algebra::ContactRelation&)>& visit);

}  // namespace tact::enumerators
