/// @file
/// The three kinds of error that tact throws, never mixed, and BudgetError, which is none: an answer was not
/// reached.
#pragma once

#include <stdexcept>
#include <string>

namespace tact {

/// Text from outside is not what it should be: `file:line: expected this, got that`.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller broke a stated precondition.
class PreconditionError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// tact is wrong: a bug of ours.
class InvariantError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Running out of a stated budget: undecided, exit status 1. The message names the budget and what it was
/// spent on.
class BudgetError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tact
