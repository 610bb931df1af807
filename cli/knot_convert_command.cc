#include "algebra/error.h"
#include "algebra/knot/dt_code.h"
#include "algebra/knot/pd_code.h"
#include "cli/commands.h"
#include "cli/json_text.h"
#include "cli/knot_inputs.h"
#include "cli/knot_print.h"
#include "cli/output.h"
#include "cli/text_pieces.h"

namespace tact::cli {
namespace {

struct Converted {
  std::string text;  // ends its last line
  std::vector<std::string> notes;
};

std::string Line(const std::string& text) { return text + "\n"; }

std::string FormOf(const knot::PData& p, const std::string& to, bool closed) {
  if (to == "rows") return ThreeRows(p);
  if (to == "json") return Line(p.ToJson());
  if (to == "gauss") return Line(knot::ToText(knot::GaussCodeOf(p)));
  if (to == "extended-gauss") return Line(knot::ToExtendedText(knot::GaussCodeOf(p)));
  if (to == "pd") return Line(knot::ToText(closed ? knot::ClosedPdCodeOf(p) : knot::PdCodeOf(p)));
  if (to == "dt") return Line(knot::DtText(knot::DtCodeOf(knot::JoinEnds(p))));
  throw InputError("--to: expected rows, json, gauss, extended-gauss, pd or dt, got \"" + to + "\"");
}

Converted Convert(const KnotOptions& options) {
  if (!options.close.empty() && options.close != "over" && options.close != "under")
    throw InputError("--close: expected over or under, got \"" + options.close + "\"");
  const bool dt = options.to == "dt", joins = dt || !options.close.empty();
  knot::PData p = (joins ? ReadPlanarKnots(options) : ReadKnots(options))[0];
  Converted converted;
  if (joins) {
    if (options.close.empty() && !knot::EndsOnOneFace(p))
      throw InputError(
          "--to dt: expected --close over or under since the ends lie on two faces, got neither");
    const int crossings = p.crossings();
    if (!options.close.empty())
      p = CloseBy(p, options.close == "over" ? knot::Pass::kOver : knot::Pass::kUnder);
    converted.notes.push_back("closed by an arc that crosses " +
                              Counted(p.crossings() - crossings, "segment") +
                              ": where the ends were is lost");
  }
  if (dt) converted.notes.push_back("a DT code does not tell a part of the knot from its mirror image");
  if (joins && options.to == "pd" && p.crossings() == 1)
    converted.notes.push_back("a PD code of one intersection does not tell which way the knot runs");
  converted.text = FormOf(p, options.to, joins);
  return converted;
}

}  // namespace

ExitStatus RunKnotConvert(const KnotOptions& options) {
  const Converted converted = Convert(options);
  for (const std::string& note : converted.notes) Note(note);
  Output output;
  if (options.json) {
    std::string text = converted.text;
    text.pop_back();
    output << "{\"form\":" << JsonString(options.to)
           << ",\"closed\":" << (options.to == "dt" || !options.close.empty() ? "true" : "false")
           << ",\"text\":" << JsonString(text) << ",\"loses\":[" << Join(converted.notes, ",", JsonString)
           << "]}\n";
  } else {
    output << converted.text;
  }
  output.Flush();
  return kAnswered;
}

}  // namespace tact::cli
