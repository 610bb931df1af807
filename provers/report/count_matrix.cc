#include "provers/report/count_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algebra/error.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr double kCell = 54, kMargin = 14, kNames = 44, kTitle = 44, kLegend = 62;

template <typename Entry>
void ExpectSquare(const std::vector<std::vector<Entry>>& rows, size_t n) {
  const bool square = rows.size() == n &&
                      std::all_of(rows.begin(), rows.end(), [n](const auto& row) { return row.size() == n; });
  if (!square) throw PreconditionError(fmt::format("a matrix of {} names has {} rows and columns", n, n));
}

struct Shade {
  int red, green, blue;
  bool dark;
};

// From pale yellow over green to deep blue.
Shade ShadeOf(double share) {
  static constexpr double kStops[4][3] = {{255, 247, 204}, {161, 218, 180}, {65, 156, 190}, {22, 50, 110}};
  const double at = std::clamp(share, 0.0, 1.0) * 3;
  const int stop = std::min(2, static_cast<int>(at));
  const double part = at - stop;
  int mix[3];
  for (int i = 0; i < 3; ++i)
    mix[i] = static_cast<int>(std::lround(kStops[stop][i] * (1 - part) + kStops[stop + 1][i] * part));
  return {mix[0], mix[1], mix[2], share > 0.55};
}

std::string Text(double x, double y, const std::string& text, double size, const std::string& style = "") {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"{}\" {}>{}</text>\n",
                     ShortDecimal(x), ShortDecimal(y), ShortDecimal(size), style, Escape(text));
}

// A cell; without a count hatched by three lines.
std::string Cell(double x, double y, uint64_t count, double largest) {
  if (count == 0) {
    std::string cell = fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#f1f0ee\"/>\n",
                                   x, y, kCell - 2, kCell - 2);
    for (const double d : {0.25, 0.5, 0.75}) {
      const double reach = 2 * std::min(d, 1 - d) * (kCell - 2) / 2;
      const double middle_x = x + d * (kCell - 2), middle_y = y + d * (kCell - 2);
      cell += fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"#cfccc6\" stroke-width=\"1.5\"/>\n",
                          ShortDecimal(middle_x - reach), ShortDecimal(middle_y + reach),
                          ShortDecimal(middle_x + reach), ShortDecimal(middle_y - reach));
    }
    return cell;
  }
  const Shade shade = ShadeOf(std::log1p(static_cast<double>(count)) / std::log1p(largest));
  const std::string number = GroupedDigits(static_cast<long long>(count));
  return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"#{:02x}{:02x}{:02x}\"/>\n", x,
                     y, kCell - 2, kCell - 2, shade.red, shade.green, shade.blue) +
         Text(x + (kCell - 2) / 2, y + kCell / 2 + 4, number, number.size() > 7 ? 11.5 : 13.5,
              fmt::format("text-anchor=\"middle\" fill=\"{}\"", shade.dark ? "#ffffff" : "#26241f"));
}

}  // namespace

std::string DrawCountMatrix(const std::vector<std::string>& names, const std::vector<CountPanel>& panels,
                            const std::vector<std::vector<bool>>& marked, const std::string& legend) {
  const size_t n = names.size();
  ExpectSquare(marked, n);
  uint64_t largest = 1;
  for (const CountPanel& panel : panels) {
    ExpectSquare(panel.counts, n);
    for (const auto& row : panel.counts)
      largest = std::max(largest, *std::max_element(row.begin(), row.end()));
  }
  const double side = static_cast<double>(n) * kCell;
  const double panel_width = kNames + side + kMargin;
  const double width = kMargin + static_cast<double>(panels.size()) * panel_width;
  const double height = kTitle + kNames / 2 + side + kLegend;
  std::string body;
  for (size_t p = 0; p < panels.size(); ++p) {
    const double left = kMargin + static_cast<double>(p) * panel_width + kNames, top = kTitle + kNames / 2;
    body += Text(left, 22, panels[p].title, 15, "font-weight=\"bold\" fill=\"#26241f\"");
    std::string marks;
    for (size_t i = 0; i < n; ++i) {
      const double along = static_cast<double>(i) * kCell;
      body +=
          Text(left + along + kCell / 2, top - 8, names[i], 13, "text-anchor=\"middle\" fill=\"#55524b\"");
      body +=
          Text(left - 8, top + along + kCell / 2 + 4, names[i], 13, "text-anchor=\"end\" fill=\"#55524b\"");
      for (size_t j = 0; j < n; ++j) {
        if (i == j) continue;
        const double x = left + static_cast<double>(j) * kCell, y = top + along;
        body += Cell(x, y, panels[p].counts[i][j], static_cast<double>(largest));
        if (!marked[i][j]) continue;
        marks += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#b5127a\" "
            "stroke-width=\"2.5\"/>\n",
            x + 1, y + 1, kCell - 4, kCell - 4);
      }
    }
    body += marks;
  }
  const double bottom = kTitle + kNames / 2 + side;
  body += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"16\" height=\"16\" fill=\"none\" stroke=\"#b5127a\" "
      "stroke-width=\"2.5\"/>\n",
      kMargin + kNames, ShortDecimal(bottom + 16));
  body += Text(kMargin + kNames + 24, bottom + 29, legend, 13, "fill=\"#26241f\"");
  body += Text(kMargin + kNames, bottom + 52,
               "from the row's DOF to the column's; shades are logarithmic; hatched: never", 12,
               "fill=\"#55524b\"");
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"img\">\n<title>{2}</title>\n{3}</svg>",
      ShortDecimal(width), ShortDecimal(height), Escape("How often each DOF becomes each other: " + legend),
      body);
}

}  // namespace tact::provers
