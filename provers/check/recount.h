/// @file
/// A census taken again: the motion DOFs of every multiset of at most so many contacts.
/// Model   A row is an implicit equality of { z | B z >= 0 } exactly if it belongs to a positive circuit: a
///         smallest set of rows with a vanishing combination, all coefficients of which are positive. With few
///         rows all sets can be tried; no evidence and no linear programming is needed.
/// Exact   64-bit + * =, every overflow detected.
/// Cost    2^largest eliminations of at most `largest` rows for each multiset, a few microseconds up to four.
#pragma once

#include <gmpxx.h>

#include <map>
#include <optional>

#include "provers/check/contact_reader.h"
#include "provers/check/motion_numbers.h"

namespace tact::check {

inline constexpr std::size_t kMaxGeneratorLargest = 64;
inline constexpr std::size_t kMaxRecount = 500000;    // multisets
inline constexpr std::size_t kMaxRecountLargest = 5;  // contacts in a multiset
inline constexpr std::size_t kMaxRecountPlanes = 8;   // planes of a contact

/// How many multisets of at most `largest` of so many contacts there are.
mpz_class MultisetCount(std::size_t contacts, std::size_t largest);

/// How many multisets have which motion DOFs; nullopt if a number left 64 bits. Preconditions: the three limits.
std::optional<std::map<MotionNumbers, std::size_t>> Recount(const std::vector<ContactNumbers>& contacts,
                                                            std::size_t largest);

}  // namespace tact::check
