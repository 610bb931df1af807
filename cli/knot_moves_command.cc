#include "algebra/error.h"
#include "algebra/knot/faces.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "robot/input/knot_move_text.h"

namespace tact::cli {

namespace {

constexpr long long kMostMoves = 1'000'000;  // a list of 150 MB in JSON

// Two darts of one face admit two R2 or more, so their number is quadratic in a face's sides.
void RefuseTooMany(const knot::PData& a) {
  long long least = 0;
  const knot::Faces faces(a);
  for (int face = 0; face < faces.count(); ++face) {
    const auto sides = static_cast<long long>(faces.walk(face).size());
    least += sides * (sides - 1);
  }
  if (least > kMostMoves) {
    throw BudgetError("moves: expected at most " + std::to_string(kMostMoves) + " moves, got " +
                      std::to_string(least) +
                      " or more; with a second P-DATA only those that lead to it are listed");
  }
}

}  // namespace

ExitStatus RunKnotMoves(const KnotOptions& options) {
  const std::vector<knot::PData> knots = ReadPlanarKnots(options);
  const knot::PData& a = knots[0];
  const bool transition = knots.size() == 2;
  std::vector<knot::Explanation> moves;
  if (transition) {
    moves = ExplainTransition(a, knots[1]);
  } else {
    RefuseTooMany(a);
    for (const knot::Move& move : AllMoves(a)) moves.push_back({move});
  }
  Output output;
  if (options.json) {
    output << "{\"moves\":[" << Join(moves, ",", input::MoveToJson) << "]}\n";
  } else {
    if (moves.empty()) output << "no single move turns the first into the second\n";
    for (const knot::Explanation& move : moves) output << MoveText(move) << "\n";
  }
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
