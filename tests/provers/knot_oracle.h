/// @file
/// Whether a certificate about a rope's moves is right, decided by algebra/knot.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"
#include "algebra/knot/thesis_rules.h"

namespace tact::provers::oracle {

/// Empty if the rows are no P-data of a sphere.
inline std::optional<knot::PData> PlanarCode(const nlohmann::json& code) {
  const auto sigma = code["sigma"].get<std::vector<int>>(), attr = code["attr"].get<std::vector<int>>();
  if (knot::PData::FindFault(sigma, attr)) return std::nullopt;
  knot::PData p(sigma, attr);
  if (!IsPlanar(p)) return std::nullopt;
  return p;
}

inline knot::Move MoveOf(const nlohmann::json& written) {
  knot::Move move;
  const std::string kind = written["kind"], direction = written["direction"];
  move.kind = kind == "R1"   ? knot::MoveKind::kR1
              : kind == "R2" ? knot::MoveKind::kR2
              : kind == "R3" ? knot::MoveKind::kR3
                             : knot::MoveKind::kCross;
  move.direction = direction == "add"      ? knot::MoveDirection::kAdd
                   : direction == "remove" ? knot::MoveDirection::kRemove
                                           : knot::MoveDirection::kShift;
  for (size_t k = 0; k < written["segments"].size(); ++k) move.segments[k] = written["segments"][k];
  move.attr = written.value("attr", 0);
  move.opposite = written.value("order", "same") == "opposite";
  const std::string end = written.value("end", "");
  if (!end.empty()) move.end = end == "selective" ? knot::RopeEnd::kSelective : knot::RopeEnd::kOther;
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

}  // namespace tact::provers::oracle
