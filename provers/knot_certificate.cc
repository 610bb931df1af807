#include "provers/knot_certificate.h"

#include "provers/knot_json.h"
#include "provers/point_json.h"
#include "robot/input/knot_move_text.h"

namespace tact::provers {
namespace {

using Json = nlohmann::ordered_json;
using knot::Move;
using knot::PData;

Json MoveJson(const Move& move) { return Json::parse(input::MoveToJson({move})); }

Json RuleHead(const std::string& claim, const std::string& rule, const PData& before, const PData& after) {
  Json json = CertificateHead(claim, "knot-rule");
  json["rule"] = Json::parse(rule);
  json["before"] = CodeJson(before);
  json["after"] = CodeJson(after);
  return json;
}

}  // namespace

Certificate KnotMoveCertificate(const std::string& name, const std::string& claim, const PData& before,
                                const Move& move, const PData& after) {
  Json json = CertificateHead(claim, "knot-move");
  json["before"] = CodeJson(before);
  json["move"] = MoveJson(move);
  json["after"] = CodeJson(after);
  return {name, json.dump() + "\n"};
}

Certificate KnotTyingCertificate(const std::string& name, const std::string& claim,
                                 const std::vector<knot::TyingStep>& steps, int at_least) {
  Json json = CertificateHead(claim, "knot-tying");
  json["p_data"] = Json::array({CodeJson(PData())});
  json["moves"] = Json::array();
  for (const knot::TyingStep& step : steps) {
    json["p_data"].push_back(CodeJson(step.reached));
    json["moves"].push_back(MoveJson(step.move));
  }
  if (at_least > 0) json["at_least"] = at_least;
  return {name, json.dump() + "\n"};
}

Certificate KnotDrawingCertificate(const std::string& name, const std::string& claim, const PData& p,
                                   const knot::Curve& curve) {
  Json json = CertificateHead(claim, "knot-drawing");
  json["p_data"] = CodeJson(p);
  json["points"] = Json::array();
  for (const algebra::Vector3& point : curve) json["points"].push_back(PointJson(point));
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
