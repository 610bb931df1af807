#include "provers/report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr double kLeft = 62, kRight = 14, kTop = 24, kBottom = 40;
constexpr const char* kText = "font-family=\"system-ui, sans-serif\" font-size=\"11\" fill=\"#5d5a54\"";

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  void Add(double value) { low = std::min(low, value), high = std::max(high, value); }
  // Never empty, with a little room.
  Range Padded(double share) const {
    if (!(low <= high)) return {0, 1};
    const double room = high > low ? share * (high - low) : std::max(std::abs(high), 1e-12) / 2;
    return {low - room, high + room};
  }
};

class Frame {
 public:
  explicit Frame(const Plot& plot) : plot_(plot) {
    Range x, y;
    for (const PlotSeries& series : plot.series) {
      for (const auto& [at, value] : series.points) x.Add(at), y.Add(value);
    }
    for (const auto& [low, high] : plot.bands) y.Add(low), y.Add(high);
    x_ = x.Padded(0.01);
    y_ = y.Padded(0.06);
  }

  double X(double at) const {
    return kLeft + (at - x_.low) / (x_.high - x_.low) * (plot_.width - kLeft - kRight);
  }
  double Y(double value) const {
    return plot_.height - kBottom - (value - y_.low) / (y_.high - y_.low) * (plot_.height - kTop - kBottom);
  }

  std::string Axes() const {
    const double right = plot_.width - kRight, bottom = plot_.height - kBottom;
    std::string body;
    for (const double tick : Ticks(y_.low, y_.high, 5)) {
      body += fmt::format(
          "<path d=\"M{} {}H{}\" stroke=\"#e4e0d6\"/><text x=\"{}\" y=\"{}\" text-anchor=\"end\" "
          "{}>{:.6g}</text>\n",
          ShortDecimal(kLeft), ShortDecimal(Y(tick)), ShortDecimal(right), ShortDecimal(kLeft - 6),
          ShortDecimal(Y(tick) + 4), kText, tick);
    }
    for (const double tick : Ticks(x_.low, x_.high, 8)) {
      body += fmt::format(
          "<path d=\"M{0} {1}V{2}\" stroke=\"#8a867d\"/><text x=\"{0}\" y=\"{3}\" text-anchor=\"middle\" "
          "{4}>{5:.6g}</text>\n",
          ShortDecimal(X(tick)), ShortDecimal(bottom), ShortDecimal(bottom + 4), ShortDecimal(bottom + 16),
          kText, tick);
    }
    body += fmt::format("<path d=\"M{} {}H{}\" stroke=\"#8a867d\"/>\n", ShortDecimal(kLeft),
                        ShortDecimal(bottom), ShortDecimal(right));
    body += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\" {}>{}</text>\n", ShortDecimal(right),
                        ShortDecimal(plot_.height - 6), kText, Escape(plot_.x_label));
    return body + fmt::format("<text x=\"4\" y=\"14\" {}>{}</text>\n", kText, Escape(plot_.y_label));
  }

 private:
  const Plot& plot_;
  Range x_, y_;
};

std::string Marks(const Frame& frame, const PlotSeries& series) {
  std::string path;
  for (const auto& [at, value] : series.points) {
    const double x = frame.X(at), y = frame.Y(value);
    const auto n = ShortDecimal;
    if (series.mark == PlotMark::kLine) {
      path += (path.empty() ? "M" : "L") + n(x) + " " + n(y);
    } else if (series.mark == PlotMark::kDots) {
      path += "M" + n(x) + " " + n(y) + "h0";  // a dot is a line of no length with round ends
    } else {
      path += fmt::format("M{} {}l6 6m-6 0l6 -6", n(x - 3), n(y - 3));
    }
  }
  if (path.empty()) return "";
  const char* width = series.mark == PlotMark::kDots ? "3.2" : "1.6";
  return fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linecap=\"round\"/>\n", path,
      series.colour, width);
}

std::string Legend(const Plot& plot) {
  std::string body;
  double x = plot.width - kRight;
  for (auto series = plot.series.rbegin(); series != plot.series.rend(); ++series) {
    if (series->name.empty() || series->points.empty()) continue;
    body += fmt::format(
        "<text x=\"{0}\" y=\"14\" text-anchor=\"end\" {1}><tspan fill=\"{2}\">{3}</tspan></text>\n",
        ShortDecimal(x), kText, series->colour, Escape(series->name));
    x -= 6.2 * static_cast<double>(series->name.size()) + 16;
  }
  return body;
}

}  // namespace

std::vector<double> Ticks(double low, double high, int count) {
  const double rough = (high - low) / count, power = std::pow(10, std::floor(std::log10(rough)));
  const double step = rough <= power       ? power
                      : rough <= 2 * power ? 2 * power
                      : rough <= 5 * power ? 5 * power
                                           : 10 * power;
  std::vector<double> ticks;
  for (double k = std::ceil(low / step); k * step <= high; ++k) ticks.push_back(k == 0 ? 0 : k * step);
  return ticks;
}

std::string DrawPlot(const Plot& plot) {
  const Frame frame(plot);
  std::string body;
  for (const auto& [low, high] : plot.bands) {
    body += fmt::format("<path d=\"M{} {}H{}V{}H{}Z\" fill=\"#dde6fb\" fill-opacity=\"0.7\"/>\n",
                        ShortDecimal(kLeft), ShortDecimal(frame.Y(low)), ShortDecimal(plot.width - kRight),
                        ShortDecimal(frame.Y(high)), ShortDecimal(kLeft));
  }
  body += frame.Axes();
  for (const PlotSeries& series : plot.series) body += Marks(frame, series);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"img\">\n"
      "<title>{2}</title>\n{3}{4}</svg>",
      ShortDecimal(plot.width), ShortDecimal(plot.height), Escape(plot.title), body, Legend(plot));
}

}  // namespace tact::provers
