/// @file
/// The integer rows of a contact relation: one row [ p x n | n ] for each separate plane [thesis, eq. (2.2)].
/// Shapes  six integers a row, without a common factor; rows in contact order, a contact's planes in theirs.
/// Exact   64-bit while every entry of every row is below 2^60; otherwise all rows are Integers.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/contact/contact_relation.h"

namespace tact::algebra {

class ContactRows {
 public:
  /// Replaces the content; keeps the memory. PreconditionError: a contact without planes, a zero normal.
  void Assign(const ContactRelation& relation);

  size_t size() const { return contact_of_row_.size(); }
  /// Whether the rows are in small(); otherwise in large().
  bool is_small() const { return is_small_; }
  const std::vector<int64_t>& small() const { return small_; }
  const std::vector<Integer>& large() const { return large_; }
  /// The rows as Integers, whichever form they have.
  std::vector<Integer> ToIntegers() const;
  const std::vector<size_t>& contact_of_row() const { return contact_of_row_; }
  /// Per row, 1 if its contact has that one plane only.
  const std::vector<char>& single() const { return single_; }
  bool singular() const { return singular_; }

 private:
  void AssignLarge(const ContactRelation& relation);

  std::vector<int64_t> small_;
  std::vector<Integer> large_;
  std::vector<size_t> contact_of_row_;
  std::vector<char> single_;
  bool is_small_ = true;
  bool singular_ = false;
};

/// The row of one plane at one point: [ p x n | n ], primitive integers.
std::vector<Integer> ContactRow(const Vector3& point, const Vector3& normal);

}  // namespace tact::algebra
