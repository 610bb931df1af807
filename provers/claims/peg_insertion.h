/// @file
/// The peg insertion of examples/peg_in_hole, recognized.
#pragma once

#include <vector>

#include "robot/recognition/recognition.h"

namespace tact::provers {

struct Insertion {
  recognition::ModelPair models;
  std::vector<input::NamedPose> states;
  recognition::Recognition seen;
};

Insertion WatchInsertion();

}  // namespace tact::provers
