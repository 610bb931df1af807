/// @file
/// The files of examples/peg_in_hole, as they are, in the program.
#pragma once

#include <string_view>

namespace tact::provers {

extern const std::string_view kPegOff;
extern const std::string_view kSlotOff;
extern const std::string_view kPegDemonstration;
extern const std::string_view kPegTurned;  // turned.json

}  // namespace tact::provers
