/// @file
/// Contact modes: which contacts a legal first-order motion can keep while it separates the others.
/// Model   A non-singular contact's gap changes at the rate a V, a = [ p x n | n ], V = [w ; v]; a singular
///         contact's at the largest of its planes' rates, as any one plane suffices. A motion is legal if no
///         rate is negative; it keeps the contacts whose rate is zero and separates the others. Without
///         singular contacts the modes are the faces of { V | A V >= 0 } [Huang et al. 2020]. With them they
///         are those of the faces of the cells where a selected plane of each singular contact has the
///         largest rate, over all selections.
/// Exact   integer arithmetic throughout. First order only: a kept contact may open or close at the second.
/// Errors  PreconditionError: a zero normal, or a contact without planes. BudgetError: see below.
/// Cost    a double description in 6 dimensions for each selection, and as many selections as the product of
///         the singular contacts' numbers of planes; then output-polynomial.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "algebra/contact/contact_relation.h"

namespace tact::algebra {

inline constexpr size_t kMaxContactModes = 1'000'000;

/// Every mode once, as a string with one letter a contact, in contact order: c kept, s separating; in
/// lexicographic order. A relation without contacts has one mode, "". BudgetError: more than max_modes modes,
/// or more than max_modes selections.
std::vector<std::string> ContactModes(const ContactRelation& relation, size_t max_modes = kMaxContactModes);

}  // namespace tact::algebra
