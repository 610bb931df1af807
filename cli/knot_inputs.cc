#include "cli/knot_inputs.h"

#include "algebra/error.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "robot/input/knot_text.h"

namespace tact::cli {
namespace {

using input::KnotSequence;

KnotSequence Read(const KnotOptions& options) {
  KnotSequence sequence = input::ReadKnotSequence(options.inputs, input::ParseView(options.view, "--view"));
  if (const auto& chosen = sequence.chosen) {
    Note("--view auto: seen from " + ToString(chosen->view) + ", " +
         Counted(chosen->Intersections(), "intersection") + ", the fewest of " +
         std::to_string(chosen->views) + " views");
  }
  return sequence;
}

std::vector<knot::PData> OneEach(const KnotSequence& sequence) {
  std::vector<knot::PData> knots;
  for (size_t i = 0; i < sequence.knots.size(); ++i) {
    const input::ReadKnot& knot = sequence.knots[i];
    if (i > 0 && sequence.knots[i - 1].argument == knot.argument)
      throw InputError(knot.place +
                       ": expected one P-data or curve, got more; tact knot recognize reads steps");
    knots.push_back(knot.p);
  }
  return knots;
}

void RefuseHandles(const KnotSequence& sequence) {
  for (const input::ReadKnot& knot : sequence.knots)
    if (const auto handle = input::FindHandle(knot.p)) throw InputError(knot.place + ": " + *handle);
}

}  // namespace

std::vector<knot::PData> ReadKnots(const KnotOptions& options) { return OneEach(Read(options)); }

std::vector<knot::PData> ReadPlanarKnots(const KnotOptions& options) {
  const KnotSequence sequence = Read(options);
  RefuseHandles(sequence);
  return OneEach(sequence);
}

std::vector<knot::PData> ReadPlanarKnotSequence(const KnotOptions& options) {
  const KnotSequence sequence = Read(options);
  RefuseHandles(sequence);
  std::vector<knot::PData> knots;
  for (const input::ReadKnot& knot : sequence.knots) knots.push_back(knot.p);
  return knots;
}

}  // namespace tact::cli
