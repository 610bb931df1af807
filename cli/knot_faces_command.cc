#include "algebra/knot/faces.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "robot/input/knot_text.h"

namespace tact::cli {
namespace {

std::string ForPeople(const knot::PData& p, const knot::Faces& faces) {
  std::string text =
      Counted(faces.count(), "face") +
      "; each walk has its face on the left: +s is segment s away from the selective end, -s toward it\n";
  const int selective = faces.left_of({1, false}), other = faces.left_of({p.segments(), true});
  for (int face = 0; face < faces.count(); ++face) {
    text += std::to_string(face + 1) + ": " + Join(faces.walk(face), " ", DartText);
    if (face == selective) text += "  selective end";
    if (face == other) text += face == selective ? ", other end" : "  other end";
    text += "\n";
  }
  return text;
}

std::string AsJson(const knot::PData& p, const knot::Faces& faces) {
  std::string walks;
  for (int face = 0; face < faces.count(); ++face) {
    if (face > 0) walks += ',';
    walks += "[" +
             Join(faces.walk(face), ",",
                  [](knot::Dart d) { return std::to_string(d.forward ? d.segment : -d.segment); }) +
             "]";
  }
  return "{\"count\":" + std::to_string(faces.count()) + ",\"genus\":" + std::to_string(knot::Genus(p)) +
         ",\"faces\":[" + walks + "],\"selective_end_on\":" + std::to_string(faces.left_of({1, false}) + 1) +
         ",\"other_end_on\":" + std::to_string(faces.left_of({p.segments(), true}) + 1) + "}\n";
}

}  // namespace

ExitStatus RunKnotFaces(const KnotOptions& options) {
  const knot::PData p = ReadKnots(options)[0];
  const knot::Faces faces(p);
  if (const auto handle = input::FindHandle(p)) Note(*handle);
  Output output;
  output << (options.json ? AsJson(p, faces) : ForPeople(p, faces));
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
