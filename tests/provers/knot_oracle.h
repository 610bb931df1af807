/// @file
/// Whether a certificate about a rope's moves is right, decided by algebra/knot.
#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"
#include "algebra/knot/thesis_rules.h"
#include "algebra/knot/tying_bound.h"

namespace tact::provers::oracle {

/// Empty if the rows are no P-data of a sphere.
inline std::optional<knot::PData> PlanarCode(const nlohmann::json& code) {
  const auto sigma = code["sigma"].get<std::vector<int>>(), attr = code["attr"].get<std::vector<int>>();
  if (knot::PData::FindFault(sigma, attr)) return std::nullopt;
  knot::PData p(sigma, attr);
  if (!IsPlanar(p)) return std::nullopt;
  return p;
}

template <typename T>
T ByName(const nlohmann::json& word, const std::map<nlohmann::json, T>& names) {
  const auto found = names.find(word);
  return found == names.end() ? static_cast<T>(-1) : found->second;
}

/// kind, direction and end as numbers of no move if a word is wrong.
inline knot::Move MoveOf(const nlohmann::json& m) {
  using enum knot::MoveKind;
  using enum knot::MoveDirection;
  using enum knot::RopeEnd;
  knot::Move move;
  move.kind = ByName<knot::MoveKind>(m["kind"], {{"R1", kR1}, {"R2", kR2}, {"R3", kR3}, {"Cross", kCross}});
  move.direction =
      ByName<knot::MoveDirection>(m["direction"], {{"add", kAdd}, {"remove", kRemove}, {"shift", kShift}});
  move.end =
      ByName<knot::RopeEnd>(m["end"], {{nullptr, kNone}, {"selective", kSelective}, {"other", kOther}});
  for (size_t k = 0; k < m["segments"].size(); ++k) move.segments.at(k) = m["segments"][k];
  move.attr = m["attr"].is_null() ? 0 : m["attr"].get<int>();
  move.opposite = m["order"] == "opposite";
  return move;
}

inline bool Leads(const knot::PData& before, const knot::Move& move, const knot::PData& after) {
  return !FindMoveFault(before, move) && Apply(before, move) == after;
}

inline bool KnotMoveIsRight(const nlohmann::json& c) {
  const auto before = PlanarCode(c["before"]), after = PlanarCode(c["after"]);
  return before && after && Leads(*before, MoveOf(c["move"]), *after);
}

inline bool RuleAccepts(const nlohmann::json& rule, const knot::PData& before, const knot::PData& after,
                        const std::vector<int>& segments) {
  if (rule["kind"] == "R2") {
    const knot::thesis::R2Reading reading{rule["same_height"], rule["signs_differ"], rule["whole_range"]};
    const auto found = FindR2(before, after, reading);
    return std::find(found.begin(), found.end(), std::pair(segments[0], segments[1])) != found.end();
  }
  const auto triangle = rule["faces"]                 ? knot::thesis::R3Triangle::kFaces
                        : rule["named_at_both_times"] ? knot::thesis::R3Triangle::kNamedTwice
                                                      : knot::thesis::R3Triangle::kNamedBefore;
  const auto found = knot::thesis::FindR3(before, after, {triangle, rule["signs_kept"], rule["whole_range"]});
  return std::any_of(found.begin(), found.end(), [&](const knot::thesis::R3Conclusion& conclusion) {
    return std::equal(segments.begin(), segments.end(), conclusion.segments.begin());
  });
}

inline bool KnotRuleIsRight(const nlohmann::json& c) {
  const auto before = PlanarCode(c["before"]), after = PlanarCode(c["after"]);
  if (!before || !after) return false;
  if (c.contains("misses")) {
    const std::vector<int> segments = c["misses"]["segments"];
    return Leads(*before, MoveOf(c["misses"]), *after) && !RuleAccepts(c["rule"], *before, *after, segments);
  }
  if (!RuleAccepts(c["rule"], *before, *after, c["accepts"])) return false;
  return DetectMoves(*before, *after).empty();  // of this number of intersections no other kind would do
}

inline bool TyingIsRight(const nlohmann::json& c) {
  std::optional<knot::PData> at = PlanarCode(c["p_data"][0]);
  if (!at || at->columns() != 0) return false;
  for (size_t k = 0; k < c["moves"].size(); ++k) {
    const auto next = PlanarCode(c["p_data"][k + 1]);
    const knot::Move move = MoveOf(c["moves"][k]);
    if (!next || !Leads(*at, move, *next)) return false;
    at = next;
  }
  if (!c.contains("at_least")) return true;
  const long long least = c["at_least"];
  return least >= 0 && least <= knot::TyingBound(*at, {}).steps();
}

}  // namespace tact::provers::oracle
