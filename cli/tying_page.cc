#include "cli/tying_page.h"

#include <filesystem>

#include "cli/tying_text.h"
#include "enumerators/whole_file.h"
#include "provers/report/html.h"
#include "provers/report/knot_drawing.h"
#include "provers/report/text.h"

namespace tact::cli {
namespace {

std::string Row(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text;
}

// The straight rope, then the rope after each step.
std::string Drawings(const knot::Tying& tying) {
  const auto drawing = [](const knot::PData& p, const std::string& caption, size_t step) {
    provers::KnotDrawingOptions options;
    options.size = 260;
    options.title = caption;
    return provers::FigureHtml({caption, provers::KnotSvg(p, options)}, "step" + std::to_string(step));
  };
  std::string html = drawing(knot::PData(), "The straight rope", 0);
  for (size_t k = 0; k < tying.steps.size(); ++k) {
    const std::string caption = "Step " + std::to_string(k + 1) + ": " + MoveInWords(tying.steps[k].move);
    html += drawing(tying.steps[k].reached, caption, k + 1);
  }
  return html;
}

std::string Page(const knot::Tying& tying, const std::string& name) {
  const std::string title = "Tying " + name;
  provers::Table table;
  table.caption =
      "Steps from the straight rope. Segments are counted from the selective end, in the P-data "
      "with fewer intersections.";
  table.header = {"Step", "Move", "Intersections", "Mates", "Attributes"};
  for (size_t k = 0; k < tying.steps.size(); ++k) {
    const auto& [move, reached] = tying.steps[k];
    table.rows.push_back({std::to_string(k + 1), MoveInWords(move), std::to_string(reached.crossings()),
                          Row(reached.SigmaRow()), Row(reached.AttrRow())});
  }
  return provers::PageHtml(title, "<h1>" + provers::Escape(title) + "</h1><p>" +
                                      provers::Escape(TyingSummary(tying)) + ".</p>" + Drawings(tying) +
                                      provers::TableHtml(table));
}

}  // namespace

void WriteTyingFolder(const knot::Tying& tying, const std::string& name, const std::string& folder) {
  const std::filesystem::path path(folder);
  enumerators::MakeFolder(path);
  enumerators::WriteWhole(path / "steps.json", TyingToJson(tying), path);
  enumerators::WriteWhole(path / "index.html", Page(tying, name), path);
}

}  // namespace tact::cli
