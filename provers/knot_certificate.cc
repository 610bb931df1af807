#include "provers/knot_certificate.h"

#include <nlohmann/json.hpp>

namespace tact::provers {
namespace {

using Json = nlohmann::ordered_json;
using knot::Move;
using knot::MoveKind;
using knot::PData;

Json Code(const PData& p) { return Json{{"sigma", p.SigmaRow()}, {"attr", p.AttrRow()}}; }

Json MoveJson(const Move& move) {
  const auto kind = [&] {
    switch (move.kind) {
      case MoveKind::kR1:
        return "R1";
      case MoveKind::kR2:
        return "R2";
      case MoveKind::kR3:
        return "R3";
      case MoveKind::kCross:
        break;
    }
    return "Cross";
  };
  const auto direction = [&] {
    switch (move.direction) {
      case knot::MoveDirection::kAdd:
        return "add";
      case knot::MoveDirection::kRemove:
        return "remove";
      case knot::MoveDirection::kShift:
        break;
    }
    return "shift";
  };
  Json json{{"kind", kind()}, {"direction", direction()}};
  json["segments"] = Json::array();
  for (const int s : move.segments) {
    if (s != 0) json["segments"].push_back(s);
  }
  if (move.attr != 0) json["attr"] = move.attr;
  if (move.kind == MoveKind::kR2) json["order"] = move.opposite ? "opposite" : "same";
  if (move.kind == MoveKind::kCross)
    json["end"] = move.end == knot::RopeEnd::kSelective ? "selective" : "other";
  return json;
}

Json Head(const std::string& claim, const std::string& kind) {
  return Json{{"format", "tact-certificate"}, {"version", 1}, {"claim", claim}, {"kind", kind}};
}

Json RuleHead(const std::string& claim, const std::string& rule, const PData& before, const PData& after) {
  Json json = Head(claim, "knot-rule");
  json["rule"] = Json::parse(rule);
  json["before"] = Code(before);
  json["after"] = Code(after);
  return json;
}

}  // namespace

Certificate KnotMoveCertificate(const std::string& name, const std::string& claim, const PData& before,
                                const Move& move, const PData& after) {
  Json json = Head(claim, "knot-move");
  json["before"] = Code(before);
  json["move"] = MoveJson(move);
  json["after"] = Code(after);
  return {name, json.dump() + "\n"};
}

std::string RuleText(const knot::thesis::R2Reading& reading) {
  return Json{{"kind", "R2"},
              {"same_height", reading.same_height},
              {"signs_differ", reading.signs_differ},
              {"whole_range", reading.equal_segments}}
      .dump();
}

std::string RuleText(const knot::thesis::R3Reading& reading) {
  using knot::thesis::R3Triangle;
  return Json{{"kind", "R3"},
              {"named_at_both_times", reading.triangle != R3Triangle::kNamedBefore},
              {"faces", reading.triangle == R3Triangle::kFaces},
              {"signs_kept", reading.same_signs},
              {"whole_range", reading.last_segment}}
      .dump();
}

Certificate MissedMoveCertificate(const std::string& name, const std::string& claim, const std::string& rule,
                                  const PData& before, const Move& move, const PData& after) {
  Json json = RuleHead(claim, rule, before, after);
  json["misses"] = MoveJson(move);
  return {name, json.dump() + "\n"};
}

Certificate WrongRuleCertificate(const std::string& name, const std::string& claim, const std::string& rule,
                                 const PData& before, const std::vector<int>& segments, const PData& after) {
  Json json = RuleHead(claim, rule, before, after);
  json["accepts"] = segments;
  return {name, json.dump() + "\n"};
}

}  // namespace tact::provers
