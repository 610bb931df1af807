#include "provers/report/step_matrix.h"

#include <fmt/format.h>

#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr const char* kFont = "font-family=\"system-ui, 'Noto Sans', 'DejaVu Sans', Helvetica, sans-serif\"";
constexpr const char* kSoft = "#5d5a54";
constexpr double kRow = 26, kLabel = 48, kHead = 24;  // pixels
constexpr double kDot = 4.5, kGroupLeft = 72, kGroupTop = 38;

std::string Open(double width, double height, const std::string& title) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" {2}>"
      "<title>{3}</title>\n",
      ShortDecimal(width), ShortDecimal(height), kFont, Escape(title));
}

std::string Text(double x, double y, const std::string& text, const char* anchor, const char* colour,
                 double size) {
  return fmt::format("<text x=\"{}\" y=\"{}\" font-size=\"{}\" text-anchor=\"{}\" fill=\"{}\">{}</text>\n",
                     ShortDecimal(x), ShortDecimal(y), ShortDecimal(size), anchor, colour, Escape(text));
}

std::string Line(double x1, double y1, double x2, double y2) {
  return fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"#d8d4ca\" stroke-width=\"1\"/>\n", ShortDecimal(x1),
                     ShortDecimal(y1), ShortDecimal(x2), ShortDecimal(y2));
}

std::string DrawCell(const MatrixCell& cell, double x, double y, double width) {
  if (cell.fill.empty()) return "";
  std::string svg = cell.title.empty() ? "<g>" : "<g><title>" + Escape(cell.title) + "</title>";
  svg += fmt::format(
      "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" rx=\"4\" fill=\"{}\" stroke=\"{}\" "
      "stroke-width=\"1.6\"/>",
      ShortDecimal(x + 1.5), ShortDecimal(y + 1.5), ShortDecimal(width - 3), ShortDecimal(kRow - 3),
      cell.fill, cell.ring ? "#7b2fa8" : "none");
  svg += Text(x + width / 2, y + kRow / 2 + 4, cell.text, "middle", "#1d1c1a", 11) + "</g>\n";
  return cell.link.empty() ? svg : fmt::format("<a href=\"{}\">{}</a>", Escape(cell.link), svg);
}

// Labels of one size along a line: the next takes the nearest lane where it does not touch the one before.
class Lanes {
 public:
  explicit Lanes(double label) : label_(label) {}

  double Place(double middle) {
    size_t lane = 0;
    while (lane < last_.size() && middle - last_[lane] < label_) ++lane;
    if (lane == last_.size()) last_.push_back(middle);
    last_[lane] = middle;
    return static_cast<double>(lane);
  }

 private:
  double label_;
  std::vector<double> last_;
};

}  // namespace

std::string DrawMatrix(const std::vector<std::string>& labels,
                       const std::vector<std::vector<MatrixCell>>& cells, double cell_width,
                       const std::string& title) {
  const double size = static_cast<double>(labels.size());
  const double right = kLabel + size * cell_width, bottom = kHead + size * kRow;
  std::string svg = Open(right + 2, bottom + 2, title);
  for (size_t i = 0; i < labels.size(); ++i) {
    const double x = kLabel + static_cast<double>(i) * cell_width, y = kHead + static_cast<double>(i) * kRow;
    svg += Text(x + cell_width / 2, kHead - 8, labels[i], "middle", kSoft, 11.5);
    svg += Text(kLabel - 8, y + kRow / 2 + 4, labels[i], "end", kSoft, 11.5);
    svg += Line(kLabel, y, right, y) + Line(x, kHead, x, bottom);
  }
  svg += Line(kLabel, bottom, right, bottom) + Line(right, kHead, right, bottom);
  for (size_t i = 0; i < labels.size(); ++i) {
    for (size_t j = 0; j < labels.size(); ++j) {
      svg += DrawCell(cells.at(i).at(j), kLabel + static_cast<double>(j) * cell_width,
                      kHead + static_cast<double>(i) * kRow, cell_width);
    }
  }
  return svg + "</svg>";
}

std::string DrawDotMatrix(const std::vector<MatrixGroup>& groups, const std::vector<MatrixDot>& dots,
                          const std::string& title) {
  size_t classes = 0;
  for (const MatrixGroup& group : groups) classes += group.classes;
  const double side = kDot * static_cast<double>(classes), right = kGroupLeft + side,
               bottom = kGroupTop + side;
  std::string svg = Open(right + 4, bottom + 4, title);
  double at = 0;
  Lanes above(30), beside(12);
  for (const MatrixGroup& group : groups) {
    const double next = at + kDot * static_cast<double>(group.classes), middle = (at + next) / 2;
    svg += Line(kGroupLeft, kGroupTop + at, right, kGroupTop + at) +
           Line(kGroupLeft + at, kGroupTop, kGroupLeft + at, bottom);
    svg +=
        Text(kGroupLeft + middle, kGroupTop - 7 - 13 * above.Place(middle), group.label, "middle", kSoft, 10);
    svg += Text(kGroupLeft - 6 - 32 * beside.Place(middle), kGroupTop + middle + 3.5, group.label, "end",
                kSoft, 10);
    at = next;
  }
  svg += Line(kGroupLeft, bottom, right, bottom) + Line(right, kGroupTop, right, bottom);
  for (const MatrixDot& dot : dots) {
    svg += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"1.9\" fill=\"{}\"><title>{}</title></circle>\n",
                       ShortDecimal(kGroupLeft + kDot * (static_cast<double>(dot.column) + 0.5)),
                       ShortDecimal(kGroupTop + kDot * (static_cast<double>(dot.row) + 0.5)), dot.fill,
                       Escape(dot.title));
  }
  return svg + "</svg>";
}

}  // namespace tact::provers
