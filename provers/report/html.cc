#include "provers/report/html.h"

#include <fmt/format.h>

#include <vector>

#include "provers/report/page.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

bool IsNumber(std::string_view cell) {
  return !cell.empty() && cell.find_first_of("0123456789") != std::string_view::npos &&
         cell.find_first_not_of("0123456789+-.,/%eE \u2212\u00B1\u202F") == std::string_view::npos;
}

// A column is set right if all its cells are numbers (or empty).
std::vector<bool> NumericColumns(const Table& table) {
  std::vector<bool> numeric(table.header.size(), !table.rows.empty());
  for (const auto& row : table.rows) {
    for (size_t i = 0; i < row.size() && i < numeric.size(); ++i) {
      numeric[i] = numeric[i] && (row[i].empty() || IsNumber(row[i]));
    }
  }
  return numeric;
}

}  // namespace

std::string PageHtml(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n<meta "
      "charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
      Escape(title), kPageStyle, body);
}

std::string TableHtml(const Table& table) {
  const std::vector<bool> numeric = NumericColumns(table);
  const auto style = [&](size_t i) { return i < numeric.size() && numeric[i] ? " class=\"number\"" : ""; };
  std::string html = fmt::format(
      "<div class=\"scroll\" role=\"region\" aria-label=\"{0}\" "
      "tabindex=\"0\"><table><caption>{0}</caption>\n<thead><tr>",
      Escape(table.caption));
  for (size_t i = 0; i < table.header.size(); ++i) {
    html += fmt::format("<th scope=\"col\"{}>{}</th>", style(i), Escape(table.header[i]));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (size_t i = 0; i < row.size(); ++i) html += fmt::format("<td{}>{}</td>", style(i), Escape(row[i]));
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string FigureHtml(const Figure& figure, const std::string& id) {
  return fmt::format(
      "<figure><div class=\"drawing\" role=\"img\" aria-labelledby=\"{0}\">{1}</div>"
      "<figcaption id=\"{0}\">{2}</figcaption></figure>\n",
      id, ValidUtf8(figure.svg), Escape(figure.caption));
}

std::string Plural(size_t count, const std::string& noun) {
  return GroupedDigits(static_cast<long long>(count)) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace tact::provers
