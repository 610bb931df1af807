#include "enumerators/contact_world.h"

#include <set>

#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"

namespace tact::enumerators {
namespace {

using algebra::Contact;
using algebra::ContactRelation;
using algebra::Integer;
using algebra::Vector3;

std::vector<Vector3> Grid() {
  std::vector<Vector3> points;
  for (const int x : {-1, 0, 1}) {
    for (const int y : {-1, 0, 1}) {
      for (const int z : {-1, 0, 1}) points.push_back({x, y, z});
    }
  }
  return points;
}

std::vector<Contact> DistinctContacts(const std::vector<Vector3>& points,
                                      const std::vector<Vector3>& normals) {
  std::vector<Contact> contacts;
  std::set<std::vector<Integer>> seen;
  for (const Vector3& n : normals) {
    for (const Vector3& p : points) {
      if (seen.insert(algebra::ContactRow(p, n)).second) contacts.push_back({p, {n}, ""});
    }
  }
  return contacts;
}

std::vector<Vector3> AxisNormals() {
  return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
}

std::vector<Vector3> CornerPoints() { return {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

void Visit(const ContactWorld& world, size_t size, size_t first, ContactRelation& relation,
           const std::function<void(const ContactRelation&)>& visit) {
  if (relation.contacts.size() == size) {
    visit(relation);
    return;
  }
  for (size_t i = first; i < world.contacts.size(); ++i) {
    relation.contacts.push_back(world.contacts[i]);
    Visit(world, size, i, relation, visit);
    relation.contacts.pop_back();
  }
}

}  // namespace

ContactWorld AxisWorld(size_t largest) {
  return {
      "all relations of at most " + std::to_string(largest) +
          " contacts at points of {-1, 0, 1}^3 with normals along the axes, contacts on one line of action "
          "being one",
      DistinctContacts(Grid(), AxisNormals()), largest};
}

ContactWorld DiagonalWorld(size_t largest) {
  std::vector<Vector3> normals = Grid();
  std::erase_if(normals, [](const Vector3& n) { return n.IsZero(); });
  return {"all relations of at most " + std::to_string(largest) +
              " contacts at points of {-1, 0, 1}^3 with normals of entries -1, 0, 1, contacts on one line of "
              "action being one",
          DistinctContacts(Grid(), normals), largest};
}

ContactWorld CubeWorld(size_t largest) {
  std::vector<Vector3> points = Grid();
  std::erase_if(points, [](const Vector3& p) { return p.x.sign() < 0 || p.y.sign() < 0 || p.z.sign() < 0; });
  return {"all relations of at most " + std::to_string(largest) +
              " contacts at the corners of a unit cube with normals along the axes, contacts on one line of "
              "action "
              "being one",
          DistinctContacts(points, AxisNormals()), largest};
}

ContactWorld CornerWorld(size_t largest) {
  std::vector<Vector3> normals = AxisNormals();
  normals.push_back({1, 1, 0});
  normals.push_back({-1, -1, 0});
  std::vector<Contact> contacts = DistinctContacts(CornerPoints(), normals);
  contacts.push_back({{0, -1, 1}, {{-1, 0, 1}}, ""});
  contacts.push_back({{-1, -1, -1}, {{0, 0, 1}}, ""});
  return {"all relations of at most " + std::to_string(largest) + " of " + std::to_string(contacts.size()) +
              " contacts: at 0, x, y, z with normals along the axes and (1, 1, 0) and (-1, -1, 0), at "
              "(0, -1, 1) with (-1, 0, 1), at (-1, -1, -1) with z",
          contacts, largest};
}

std::vector<std::string> WorldNames() { return {"corner", "cube", "axis", "diagonal"}; }

ContactWorld NamedWorld(const std::string& name, size_t largest) {
  if (name == "corner") return CornerWorld(largest);
  if (name == "cube") return CubeWorld(largest);
  if (name == "axis") return AxisWorld(largest);
  if (name == "diagonal") return DiagonalWorld(largest);
  throw PreconditionError("no world is named " + name + "; there are corner, cube, axis and diagonal");
}

ContactWorld SingularWorld(size_t largest) {
  const std::vector<Vector3> points = CornerPoints();
  const std::vector<Vector3> normals = AxisNormals();
  std::vector<Contact> contacts = DistinctContacts(points, normals);
  for (const Vector3& p : points) {
    for (size_t i = 0; i < normals.size(); ++i) {
      for (size_t j = i + 1; j < normals.size(); ++j) {
        if (!algebra::Parallel(normals[i], normals[j])) contacts.push_back({p, {normals[i], normals[j]}, ""});
      }
    }
  }
  return {
      "all relations of at most " + std::to_string(largest) +
          " contacts at 0, x, y, z with one normal along an axis or two square ones of which either suffices",
      contacts, largest};
}

size_t Count(const ContactWorld& world) {
  // Multisets of size k: binomial(n + k - 1, k).
  size_t total = 0, multisets = 1;
  for (size_t k = 0; k <= world.largest; ++k) {
    total += multisets;
    multisets = multisets * (world.contacts.size() + k) / (k + 1);
  }
  return total;
}

void ForEachRelation(const ContactWorld& world, const std::function<void(const ContactRelation&)>& visit) {
  ContactRelation relation;
  for (size_t size = 0; size <= world.largest; ++size) Visit(world, size, 0, relation, visit);
}

}  // namespace tact::enumerators
