/// @file
/// The search behind TieShortest (tying.h): from a knot to the straight rope, level by level.
/// Model   Level k has the P-data through which a sequence of bound + k steps can lead, and none of fewer. The bound is
///         consistent, so a move of detour d (tying_bound.h) leads from level k to level k + d, and each P-data belongs to
///         the first level that reaches it: nothing is ever searched twice.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "algebra/knot/p_data_store.h"
#include "algebra/knot/tying.h"

namespace tact::knot {

/// A move that was read off from p, applied without the check of Apply.
PData ApplyFound(const PData& p, const Move& move);
/// The moves that take intersections away: R2, R1, then Cross of the other end and of the selective one.
void ListRemovals(const PData& p, const MoveRules& rules, std::vector<Move>& moves);
/// Steps that undo a knot, turned into steps that tie it; undoing[k] leads from states[k] to states[k + 1].
std::vector<TyingStep> TurnRound(std::vector<PData> states, const std::vector<Move>& undoing);

class TyingSearch {
 public:
  /// Without additions the P-data are few; what is found then is a sequence, not always a shortest. Keeps a reference to options.
  TyingSearch(const PData& knot, const TyingOptions& options, bool additions, size_t most_states);

  /// Searches the next level, the first time that of the knot itself, until the straight rope is found (true), the level ends or
  /// the budget is spent (false).
  bool SearchLevel();
  bool spent() const {
    return store_.size() > most_states_ || store_.bytes() + 12 * store_.size() > options_.most_bytes;
  }
  /// Whether no level after this one has anything.
  bool exhausted() const;
  size_t states() const { return store_.size(); }
  /// After the straight rope was found.
  std::vector<TyingStep> Steps() const;

 private:
  bool Drain();
  bool Open(uint32_t state, int detour);
  Move MoveBetween(const PData& p, const PData& q) const;

  const TyingOptions& options_;
  const bool additions_;
  const size_t most_states_;
  PDataStore store_;
  std::vector<uint32_t> came_;                 // from which state
  std::vector<std::vector<uint32_t>> levels_;  // what was opened
  std::vector<uint32_t> open_;
  std::vector<Move> moves_;
};

}  // namespace tact::knot
