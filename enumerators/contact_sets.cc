#include "enumerators/contact_sets.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "algebra/contact/contact_rows.h"
#include "algebra/error.h"

namespace tact::enumerators {
namespace {

constexpr uint64_t kMostRelations = uint64_t{1} << 63;

}  // namespace

ContactSets::ContactSets(size_t contacts, size_t largest)
    : contacts_(contacts), largest_(std::min(largest, contacts)) {
  choose_.assign(contacts_ + 1, std::vector<uint64_t>(largest_ + 1, 0));
  for (size_t i = 0; i <= contacts_; ++i) {
    choose_[i][0] = 1;
    for (size_t k = 1; k <= std::min(i, largest_); ++k) {
      choose_[i][k] = choose_[i - 1][k - 1] + choose_[i - 1][k];
      if (choose_[i][k] >= kMostRelations) throw PreconditionError("a world of more than 2^63 relations");
    }
  }
  for (size_t k = 0; k <= largest_; ++k) {
    smaller_.push_back(size_);
    size_ += choose_[contacts_][k];
    if (size_ >= kMostRelations) throw PreconditionError("a world of more than 2^63 relations");
  }
}

std::vector<size_t> ContactSets::At(uint64_t number) const {
  if (number >= size_)
    throw PreconditionError("no relation " + std::to_string(number) + " of " + std::to_string(size_));
  size_t size = largest_;
  while (smaller_[size] > number) --size;
  number -= smaller_[size];
  std::vector<size_t> set;
  for (size_t i = 0; set.size() < size; ++i) {
    const uint64_t with_i = choose_[contacts_ - 1 - i][size - set.size() - 1];
    if (number < with_i) {
      set.push_back(i);
    } else {
      number -= with_i;
    }
  }
  return set;
}

void ContactSets::Advance(std::vector<size_t>& set) const {
  for (size_t i = set.size(); i-- > 0;) {
    if (set[i] == contacts_ - set.size() + i) continue;
    std::iota(set.begin() + static_cast<std::ptrdiff_t>(i), set.end(), set[i] + 1);
    return;
  }
  set.resize(set.size() + 1);
  std::iota(set.begin(), set.end(), size_t{0});
}

bool ComesBefore(const std::vector<size_t>& a, const std::vector<size_t>& b) {
  return a.size() != b.size() ? a.size() < b.size() : a < b;
}

std::vector<int64_t> WorldRows(const ContactWorld& world) {
  std::vector<int64_t> rows;
  for (const algebra::Contact& contact : world.contacts) {
    if (contact.singular()) throw PreconditionError("a census of DOF classes takes contacts with one plane");
    algebra::ContactRows row;
    row.Assign({{contact}});
    if (!row.is_small()) throw PreconditionError("a census of DOF classes takes contacts of 64-bit numbers");
    rows.insert(rows.end(), row.small().begin(), row.small().end());
  }
  return rows;
}

}  // namespace tact::enumerators
