/// @file
/// The states of examples/peg_in_hole.
#pragma once

#include <fstream>
#include <string>

#include "robot/planning/demonstration_plan.h"

namespace tact::planning {

inline DemonstrationStates PegStates(const std::string& file) {
  const std::string path = std::string(TACT_SOURCE_DIR) + "/examples/peg_in_hole/" + file;
  std::ifstream in(path);
  return StatesOf(input::ReadDemonstration(in, path), path);
}

}  // namespace tact::planning
