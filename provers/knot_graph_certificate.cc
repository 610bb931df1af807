#include "provers/knot_graph_certificate.h"

#include <algorithm>
#include <array>

#include "algebra/knot/reducible.h"
#include "algebra/knot/thesis_graphs.h"
#include "provers/knot_json.h"

namespace tact::provers {
namespace {

using Json = nlohmann::ordered_json;
using knot::PData;

Json Begin(const std::string& claim, const std::string& kind, const PData& p) {
  Json json = CertificateHead(claim, kind);
  json["p_data"] = CodeJson(p);
  return json;
}

}  // namespace

std::vector<int> EdgesOf(knot::thesis::EdgeSet set) {
  std::vector<int> edges;
  for (int k = 1; set != 0; ++k, set >>= 1) {
    if ((set & 1) != 0) edges.push_back(k);
  }
  return edges;
}

Certificate KnotEmbeddingCertificate(const std::string& name, const std::string& claim, const PData& p,
                                     const knot::Rotation& rotation, bool nameless) {
  Json json = Begin(claim, "knot-embedding", p);
  json["rotation"] = rotation;
  json["nameless"] = nameless;
  return {name, json.dump() + "\n"};
}

Certificate KnotFaceSearchCertificate(const std::string& name, const std::string& claim, const PData& p,
                                      const knot::thesis::FaceSearchReading& reading,
                                      const knot::thesis::FaceSearchOutcome& outcome) {
  constexpr std::array kCautions = {"none", "edges", "segments", "every-vertex"};
  constexpr std::array kOrders = {"shortest-first", "edge-by-edge", "corner-by-corner"};
  Json json = Begin(claim, "knot-face-search", p);
  json["rule"] = {{"caution", kCautions[static_cast<size_t>(reading.caution)]},
                  {"order", kOrders[static_cast<size_t>(reading.order)]}};
  json["chooses"] = outcome.stuck ? std::vector<int>{} : EdgesOf(outcome.chosen.back());
  json["always"] = !outcome.right;
  return {name, json.dump() + "\n"};
}

Certificate KnotPartsCertificate(const std::string& name, const std::string& claim, const PData& p) {
  Json json = Begin(claim, "knot-parts", p);
  const std::vector<int> classes = InterlacementClasses(p);
  std::vector<std::vector<int>> parts;
  for (int i = 1; i <= p.columns(); ++i) {
    const auto part = static_cast<size_t>(classes[static_cast<size_t>(i)]);
    if (part == parts.size()) parts.emplace_back();
    parts[part].push_back(i);
  }
  json["parts"] = parts;
  return {name, json.dump() + "\n"};
}

Certificate KnotSubdivisionCertificate(const std::string& name, const std::string& claim, const PData& p,
                                       int external, const std::vector<int>& without) {
  Json json = Begin(claim, "knot-subdivision", p);
  std::vector<knot::EdgeWalk> faces = KnotGraphFaces(p);
  for (knot::EdgeWalk& face : faces) std::sort(face.begin(), face.end());
  std::rotate(faces.begin(), faces.begin() + external, faces.begin() + external + 1);
  json["faces"] = faces;
  json["without"] = without;
  return {name, json.dump() + "\n"};
}

}  // namespace tact::provers
