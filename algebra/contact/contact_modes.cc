#include "algebra/contact/contact_modes.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "algebra/cone/cone.h"
#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"

namespace tact::algebra {
namespace {

constexpr size_t kTwistDimension = 6;

// The rows of a contact's planes, each once: the sign of the largest rate does not depend on the rows'
// lengths.
std::vector<IntegerVector> DistinctRows(const Contact& contact, size_t index) {
  if (contact.planes.empty()) {
    throw PreconditionError("contact " + std::to_string(index + 1) +
                            ": expected at least one separate plane, got none");
  }
  std::vector<IntegerVector> rows;
  for (const Vector3& normal : contact.planes) {
    if (normal.IsZero()) {
      throw PreconditionError("contact " + std::to_string(index + 1) +
                              ": expected a normal, got the zero vector");
    }
    IntegerVector row = ContactRow(contact.point, normal);
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) rows.push_back(std::move(row));
  }
  return rows;
}

[[noreturn]] void ThrowBudget(size_t max_modes, const char* what) {
  throw BudgetError("contact modes: the budget of " + std::to_string(max_modes) + " " + what + " is spent");
}

// One selection's cell: where the selected row of each contact is legal and at least the contact's other
// rows. row i < contacts is the selected row of contact i.
HalfspaceCone Cell(const std::vector<std::vector<IntegerVector>>& contacts,
                   const std::vector<size_t>& selection) {
  IntegerMatrix rows(0, kTwistDimension);
  for (size_t i = 0; i < contacts.size(); ++i) rows.AppendRow(contacts[i][selection[i]]);
  for (size_t i = 0; i < contacts.size(); ++i) {
    for (size_t j = 0; j < contacts[i].size(); ++j) {
      if (j == selection[i]) continue;
      IntegerVector difference = contacts[i][selection[i]];
      for (size_t k = 0; k < kTwistDimension; ++k) difference[k] -= contacts[i][j][k];
      rows.AppendRow(difference);
    }
  }
  return HalfspaceCone(std::move(rows));
}

// Contacts that the same rays keep are kept by the same faces: they are one column. Columns are numbered in the order
// of their first contacts, so the order of modes is that of columns.
struct Columns {
  std::vector<size_t> of_contact;
  size_t count = 0;
};

Columns GroupContacts(const ConeGenerators& generators, size_t contacts) {
  Columns columns;
  std::map<std::vector<size_t>, size_t> column_of_rays;
  for (size_t i = 0; i < contacts; ++i) {
    std::vector<size_t> rays;
    for (size_t k = 0; k < generators.tight.size(); ++k) {
      if (generators.tight[k].Contains(i)) rays.push_back(k);
    }
    const auto [at, fresh] = column_of_rays.try_emplace(std::move(rays), columns.count);
    if (fresh) ++columns.count;
    columns.of_contact.push_back(at->second);
  }
  return columns;
}

std::vector<std::string> ModesOfCell(const HalfspaceCone& cell, size_t contacts, size_t max_modes) {
  const ConeGenerators generators = Generators(cell);
  const Columns columns = GroupContacts(generators, contacts);
  std::vector<RowSet> tight;
  for (const RowSet& all_rows : generators.tight) {
    RowSet& of_columns = tight.emplace_back(columns.count);
    for (size_t i = 0; i < contacts; ++i) {
      if (all_rows.Contains(i)) of_columns.Insert(columns.of_contact[i]);
    }
  }
  std::vector<std::string> modes;
  const bool complete =
      VisitIntersections(tight, columns.count, [&](const RowSet& kept, std::span<const size_t> /*rays*/) {
        if (modes.size() == max_modes) return false;
        std::string& mode = modes.emplace_back(contacts, 's');
        for (size_t i = 0; i < contacts; ++i) {
          if (kept.Contains(columns.of_contact[i])) mode[i] = 'c';
        }
        return true;
      });
  if (!complete) ThrowBudget(max_modes, "modes");
  return modes;
}

// The next selection in counting order; false after the last.
bool Advance(const std::vector<std::vector<IntegerVector>>& contacts, std::vector<size_t>& selection) {
  for (size_t i = 0; i < contacts.size(); ++i) {
    if (++selection[i] < contacts[i].size()) return true;
    selection[i] = 0;
  }
  return false;
}

}  // namespace

std::vector<std::string> ContactModes(const ContactRelation& relation, size_t max_modes) {
  std::vector<std::vector<IntegerVector>> contacts;
  size_t selections = 1;
  for (size_t i = 0; i < relation.contacts.size(); ++i) {
    contacts.push_back(DistinctRows(relation.contacts[i], i));
    if (selections > max_modes / contacts[i].size()) ThrowBudget(max_modes, "selections of planes");
    selections *= contacts[i].size();
  }
  std::vector<std::string> modes;
  std::vector<size_t> selection(contacts.size());
  do {
    const std::vector<std::string> found = ModesOfCell(Cell(contacts, selection), contacts.size(), max_modes);
    std::vector<std::string> merged;
    std::set_union(modes.begin(), modes.end(), found.begin(), found.end(), std::back_inserter(merged));
    if (merged.size() > max_modes) ThrowBudget(max_modes, "modes");
    modes.swap(merged);
  } while (Advance(contacts, selection));
  return modes;
}

}  // namespace tact::algebra
