#include <cstdlib>

#include "algebra/knot/closure.h"
#include "algebra/knot/reducible.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

struct Findings {
  int vertices = 0, segments = 0, faces = 0, genus = 0, writhe = 0;
  bool alternating = true, one_face = false;
  std::vector<knot::Part> parts;
};

Findings Examine(const knot::PData& p) {
  Findings found;
  found.vertices = p.crossings() + 2;
  found.segments = p.segments();
  found.faces = knot::CountFaces(p);
  found.genus = (2 - found.vertices + found.segments - found.faces) / 2;
  for (int i = 1; i <= p.columns(); ++i) {
    if (p.over(i)) found.writhe += p.sign(i);
    if (i > 1 && p.over(i) == p.over(i - 1)) found.alternating = false;
  }
  found.one_face = knot::EndsOnOneFace(p);
  found.parts = knot::Split(p);
  return found;
}

std::string YesNo(bool holds) { return holds ? "yes" : "no"; }
std::string Bool(bool holds) { return holds ? "true" : "false"; }

std::string ForPeople(const knot::PData& p, const Findings& found) {
  const auto line = [](std::string name, const std::string& value) {
    name.resize(20, ' ');
    return name + value + "\n";
  };
  std::string text = line("P-data", TwoRows(p));
  text += line("on a sphere", (found.genus == 0 ? "yes" : "no, genus " + std::to_string(found.genus)) + ": " +
                                  Counted(found.faces, "face") + " - " + Counted(found.segments, "segment") +
                                  " + " + std::to_string(found.vertices) +
                                  " intersections and ends = " + std::to_string(2 - 2 * found.genus));
  text += line("intersections", std::to_string(p.crossings()));
  text += line("writhe", std::to_string(found.writhe));
  text += line("alternating", YesNo(found.alternating));
  text += line("ends on one face", YesNo(found.one_face));
  const bool irreducible = found.parts.size() <= 1;
  text += line("irreducible",
               irreducible ? "yes" : "no, " + Counted(static_cast<int>(found.parts.size()), "part") + ":");
  for (size_t t = 0; t < found.parts.size() && !irreducible; ++t) {
    text += line(
        "  part " + std::to_string(t + 1),
        TwoRows(found.parts[t].p) +
            (t == 0 ? "" : "  in segment " + std::to_string(found.parts[t].segment) + " of those above"));
  }
  const knot::PData equivalent = EquivalentPData(p);
  text += line("from the other end", equivalent == p ? "the same" : TwoRows(equivalent));
  text += line("canonical form", TwoRows(CanonicalPData(p)));
  text += line("mirrored shape", TwoRows(MirrorShape(p)));
  text += line("mirrored heights", TwoRows(MirrorHeights(p)));
  return text;
}

std::string AsJson(const knot::PData& p, const Findings& found) {
  const auto parts = Join(found.parts, ",", [](const knot::Part& part) {
    return "{\"p_data\":" + part.p.ToJson() + ",\"segment\":" + std::to_string(part.segment) + "}";
  });
  return "{\"p_data\":" + p.ToJson() + ",\"planar\":" + Bool(found.genus == 0) +
         ",\"genus\":" + std::to_string(found.genus) + ",\"crossings\":" + std::to_string(p.crossings()) +
         ",\"segments\":" + std::to_string(found.segments) + ",\"faces\":" + std::to_string(found.faces) +
         ",\"writhe\":" + std::to_string(found.writhe) + ",\"alternating\":" + Bool(found.alternating) +
         ",\"ends_on_one_face\":" + Bool(found.one_face) +
         ",\"irreducible\":" + Bool(found.parts.size() <= 1) + ",\"parts\":[" + parts +
         "],\"equivalent\":" + EquivalentPData(p).ToJson() + ",\"canonical\":" + CanonicalPData(p).ToJson() +
         ",\"mirror_shape\":" + MirrorShape(p).ToJson() + ",\"mirror_heights\":" + MirrorHeights(p).ToJson() +
         "}\n";
}

}  // namespace

ExitStatus RunKnotCheck(const KnotOptions& options) {
  const knot::PData p = ReadKnots(options)[0];
  const Findings found = Examine(p);
  Output output;
  output << (options.json ? AsJson(p, found) : ForPeople(p, found));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
