/// @file
/// Uniform choices for properties. rapidcheck's inRange grows with the run's size, so that most runs of a
/// property would see the smallest instances only.
#pragma once

#include <rapidcheck.h>

namespace tact {

/// low <= result < high, every value alike in every run; shrinks towards low.
template <typename Number>
Number Uniform(Number low, Number high) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Number>(low, high));
}

}  // namespace tact
