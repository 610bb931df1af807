/// @file
/// The three kinds of error that tact throws; they are never mixed.
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

}  // namespace tact
