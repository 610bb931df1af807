#include <filesystem>

#include "algebra/error.h"
#include "algebra/knot/exact_drawing.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/output.h"
#include "cli/png_file.h"
#include "provers/knot_certificate.h"
#include "provers/report/knot_drawing.h"

namespace tact::cli {
namespace {

namespace fs = std::filesystem;

int ReadOuter(const KnotOptions& options, const knot::PData& p) {
  if (!options.outer) return BestOuterFace(knot::Faces(p), p.segments());
  const int faces = p.crossings() + 1;
  if (*options.outer >= 1 && *options.outer <= faces) return static_cast<int>(*options.outer) - 1;
  throw InputError("--outer: expected a face from 1 to " + std::to_string(faces) +
                   " (tact knot faces lists them), got " + std::to_string(*options.outer));
}

}  // namespace

ExitStatus RunKnotDraw(const KnotOptions& options) {
  const knot::PData p = ReadPlanarKnots(options)[0];
  const int outer = ReadOuter(options, p);
  const bool png = fs::path(options.output).extension() == ".png";
  if (!options.output.empty() && !png && fs::path(options.output).extension() != ".svg")
    throw InputError("-o: expected a file that ends in .svg or .png, got " + options.output);
  if (!options.certificate.empty()) {
    const provers::Certificate certificate =
        provers::KnotDrawingCertificate("", "drawing", p, DrawExactly(p, outer));
    WriteFile(options.certificate, certificate.json);
  }
  Output output;
  if (options.json) {
    output << provers::KnotDrawingCertificate("", "drawing", p, DrawExactly(p, outer)).json;
  } else if (options.output.empty()) {
    output << provers::KnotSvg(p, {outer, options.exact, options.labels, 480, ""}) + "\n";
  }
  output.Flush();
  if (options.output.empty()) return kAnswered;
  const std::string svg = provers::KnotSvg(p, {outer, options.exact, options.labels, 480, ""});
  if (png)
    WritePng(options.output, svg);
  else
    WriteFile(options.output, svg + "\n");
  return kAnswered;
}

}  // namespace tact::cli
