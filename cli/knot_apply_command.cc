#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "robot/input/knot_move_text.h"

namespace tact::cli {

ExitStatus RunKnotApply(const KnotOptions& options) {
  const knot::PData a = ReadPlanarKnots(options)[0];
  const knot::Explanation explanation = input::ReadMove(options.move);
  if (const auto fault = FindMoveFault(a, explanation.move)) throw InputError("MOVE: " + *fault);
  const knot::PData moved = Apply(a, explanation.move);
  const knot::PData b = explanation.swapped ? EquivalentPData(moved) : moved;
  Output output;
  output << (options.json ? b.ToJson() + "\n" : ThreeRows(b));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
