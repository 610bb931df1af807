/// @file
/// Whether a certificate of kind "knot-tying" is right, decided by the engine. Included by certificate_oracle.h.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "algebra/knot/faces.h"
#include "algebra/knot/move.h"
#include "algebra/knot/tying_bound.h"

namespace tact::provers::oracle {

inline std::optional<knot::PData> RightPData(const nlohmann::json& p) {
  const std::vector<int> sigma = p["sigma"], attr = p["attr"];
  if (knot::PData::FindFault(sigma, attr)) return std::nullopt;
  const knot::PData read(sigma, attr);
  return IsPlanar(read) ? std::optional(read) : std::nullopt;
}

template <typename T>
T ByName(const nlohmann::json& word, const std::map<nlohmann::json, T>& names) {
  const auto found = names.find(word);
  return found == names.end() ? static_cast<T>(-1) : found->second;
}

/// kind, direction and end as numbers of no move if a word is wrong.
inline knot::Move ReadMove(const nlohmann::json& m) {
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

inline bool TyingIsRight(const nlohmann::json& c) {
  std::optional<knot::PData> at = RightPData(c["p_data"][0]);
  if (!at || at->columns() != 0) return false;
  for (size_t k = 0; k < c["moves"].size(); ++k) {
    const auto next = RightPData(c["p_data"][k + 1]);
    const knot::Move move = ReadMove(c["moves"][k]);
    if (!next || FindMoveFault(*at, move) || Apply(*at, move) != *next) return false;
    at = next;
  }
  if (!c.contains("at_least")) return true;
  const long long least = c["at_least"];
  return least >= 0 && least <= knot::TyingBound(*at, {}).steps();
}

}  // namespace tact::provers::oracle
