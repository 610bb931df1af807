#include "cli/tying_page.h"

#include <filesystem>

#include "cli/tying_text.h"
#include "enumerators/whole_file.h"
#include "provers/report/html.h"
#include "provers/report/text.h"

namespace tact::cli {
namespace {

std::string Row(const std::vector<int>& numbers) {
  std::string text;
  for (const int number : numbers) text += (text.empty() ? "" : " ") + std::to_string(number);
  return text;
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
                                      provers::Escape(TyingSummary(tying)) + ".</p>" +
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
