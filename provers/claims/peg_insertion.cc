#include "provers/claims/peg_insertion.h"

#include <sstream>

#include "provers/claims/peg_in_hole_example.h"
#include "robot/cad/mesh.h"

namespace tact::provers {

Insertion WatchInsertion() {
  Insertion insertion;
  std::istringstream text{std::string(kPegDemonstration)};
  auto demonstration = std::get<input::PoseDemonstration>(
      input::ReadDemonstration(text, "examples/peg_in_hole/demonstration.json"));
  const cad::LengthUnit unit = demonstration.models.unit;
  insertion.models.unit = unit;
  insertion.models.tolerance = demonstration.models.tolerance;
  insertion.models.moving = ReadMesh(kPegOff, cad::MeshFormat::kOff, "peg.off", unit, unit).solid;
  insertion.models.fixed = ReadMesh(kSlotOff, cad::MeshFormat::kOff, "slot.off", unit, unit).solid;
  insertion.states = std::move(demonstration.states);
  insertion.seen = Recognize(insertion.models, insertion.states);
  return insertion;
}

}  // namespace tact::provers
