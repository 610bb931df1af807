/// @file
/// The motion DOFs of a relation as named numbers, and linear assertions about them.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "provers/check/json_value.h"

namespace tact::check {

inline constexpr std::array<std::string_view, 14> kIndexNames = {
    "translation.maintaining",  "translation.detaching",
    "translation.constraining", "translation.restricted",
    "rotation.maintaining",     "rotation.detaching",
    "rotation.detaching_type1", "rotation.detaching_type2",
    "rotation.constraining",    "rotation.restricted",
    "all.maintaining",          "all.detaching",
    "all.constraining",         "all.restricted"};

struct MotionNumbers {
  bool singular = false;
  std::array<int, kIndexNames.size()> values{};  // in the order of kIndexNames

  /// By name; the name is one of kIndexNames.
  int& operator[](std::string_view name);
  int operator[](std::string_view name) const { return const_cast<MotionNumbers&>(*this)[name]; }
  friend auto operator<=>(const MotionNumbers&, const MotionNumbers&) = default;
};

/// The ranks that motion DOFs follow from, with A, N, A', N', I_a, I_t as in docs/certificates.md.
struct Ranks {
  bool singular = false;
  int a = 0, n = 0;
  int a_in_all = 0, n_in_all = 0;                  // A[I_a], N[I_a]
  int a_in_translation = 0, n_in_translation = 0;  // A[I_t], N[I_t]
  int planes = 0, plane_forces = 0;                // A', N'
  friend auto operator<=>(const Ranks&, const Ranks&) = default;
};
MotionNumbers FromRanks(const Ranks& ranks);

/// The position of a name in kIndexNames; kIndexNames.size() if it is none.
std::size_t IndexOf(std::string_view name);

/// Refuses a "dof" object that is not exactly these numbers.
void ExpectNumbers(const Value& dof, const MotionNumbers& numbers);

/// Refuses "asserts" unless each is well formed and holds for these numbers.
void CheckAsserts(const Value& asserts, const MotionNumbers& numbers);

}  // namespace tact::check
