#include "provers/tying_certificate.h"

namespace tact::provers {

std::string MoveToJson(const knot::Move& move) {
  constexpr const char* kKinds[] = {"R1", "R2", "R3", "Cross"};
  constexpr const char* kDirections[] = {"add", "remove", "shift"};
  constexpr const char* kEnds[] = {"null", "\"selective\"", "\"other\""};
  std::string segments;
  for (const int segment : move.segments) {
    if (segment != 0) segments += (segments.empty() ? "" : ",") + std::to_string(segment);
  }
  return std::string("{\"kind\":\"") + kKinds[static_cast<size_t>(move.kind)] + "\",\"direction\":\"" +
         kDirections[static_cast<size_t>(move.direction)] + "\",\"segments\":[" + segments +
         "],\"end\":" + kEnds[static_cast<size_t>(move.end)] +
         ",\"selective_end\":\"same\",\"attr\":" + (move.attr == 0 ? "null" : std::to_string(move.attr)) +
         ",\"order\":" +
         (move.kind != knot::MoveKind::kR2 ? "null"
          : move.opposite                  ? "\"opposite\""
                                           : "\"same\"") +
         "}";
}

Certificate KnotTyingCertificate(const std::string& name, const std::string& claim,
                                 const std::vector<knot::TyingStep>& steps, int at_least) {
  std::string p_data = knot::PData().ToJson(), moves;
  for (const knot::TyingStep& step : steps) {
    p_data += "," + step.reached.ToJson();
    moves += (moves.empty() ? "" : ",") + MoveToJson(step.move);
  }
  return {name, "{\"format\":\"tact-certificate\",\"version\":1,\"claim\":\"" + claim +
                    "\",\"kind\":\"knot-tying\",\"p_data\":[" + p_data + "],\"moves\":[" + moves + "]" +
                    (at_least > 0 ? ",\"at_least\":" + std::to_string(at_least) : "") + "}"};
}

}  // namespace tact::provers
