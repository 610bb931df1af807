#include "provers/report/log_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "algebra/error.h"
#include "provers/report/text.h"

namespace tact::provers {
namespace {

constexpr double kWidth = 300, kHeight = 250, kLeft = 48, kRight = 104, kTop = 30, kBottom = 42;
constexpr std::array kColours = {"#16326e", "#2a8a6d", "#b5541c", "#7a3e9d"};

// A range of positive numbers on a logarithmic axis of some pixels, with a little room at both ends.
class LogAxis {
 public:
  LogAxis(double least, double most, double start, double end) : start_(start), end_(end) {
    const double room = 0.08 * std::max(std::log(most / least), 0.1);
    low_ = std::log(least) - room;
    high_ = std::log(most) + room;
  }
  double At(double value) const {
    return start_ + (std::log(value) - low_) / (high_ - low_) * (end_ - start_);
  }
  // 1, 2 and 5 times powers of ten within.
  std::vector<double> Ticks() const {
    std::vector<double> ticks;
    for (int power = -6; power <= 6; ++power) {
      for (const double digit : {1.0, 2.0, 5.0}) {
        const double value = digit * std::pow(10, power);
        if (std::log(value) >= low_ && std::log(value) <= high_) ticks.push_back(value);
      }
    }
    return ticks;
  }

 private:
  double start_, end_, low_ = 0, high_ = 1;
};

std::string Text(double x, double y, const std::string& text, const char* anchor,
                 const std::string& colour = "#333") {
  return fmt::format(
      "<text x=\"{}\" y=\"{}\" font-family=\"sans-serif\" font-size=\"12\" text-anchor=\"{}\" "
      "fill=\"{}\">{}</text>\n",
      ShortDecimal(x), ShortDecimal(y), anchor, colour, Escape(text));
}

std::string Line(double x0, double y0, double x1, double y1, const char* colour) {
  return fmt::format("<path d=\"M{} {}L{} {}\" stroke=\"{}\" fill=\"none\"/>\n", ShortDecimal(x0),
                     ShortDecimal(y0), ShortDecimal(x1), ShortDecimal(y1), colour);
}

}  // namespace

std::string DrawLogPlot(const LogPlot& plot) {
  std::vector<double> all;
  for (const PlotSeries& series : plot.series) {
    if (series.values.size() != plot.sizes.size() ||
        (!series.printed.empty() && series.printed.size() != plot.sizes.size())) {
      throw PreconditionError(
          fmt::format("DrawLogPlot: expected {} values in the series '{}'", plot.sizes.size(), series.name));
    }
    all.insert(all.end(), series.values.begin(), series.values.end());
    all.insert(all.end(), series.printed.begin(), series.printed.end());
  }
  if (all.empty() || *std::min_element(all.begin(), all.end()) <= 0)
    throw PreconditionError("DrawLogPlot: expected positive values");
  const double right = kLeft + kWidth, bottom = kTop + kHeight;
  const LogAxis x(plot.sizes.front(), plot.sizes.back(), kLeft, right);
  const LogAxis y(*std::min_element(all.begin(), all.end()), *std::max_element(all.begin(), all.end()),
                  bottom, kTop);
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "role=\"img\">"
      "<title>{2}</title>\n",
      kLeft + kWidth + kRight, kTop + kHeight + kBottom, Escape(plot.title));
  svg += Text(kLeft, 16, plot.y_name, "start");
  for (const double tick : y.Ticks()) {
    svg += Line(kLeft, y.At(tick), right, y.At(tick), "#e4e2de");
    svg += Text(kLeft - 6, y.At(tick) + 4, fmt::format("{}", tick), "end");
  }
  for (const double size : plot.sizes) {
    svg += Line(x.At(size), kTop, x.At(size), bottom, "#e4e2de");
    svg += Text(x.At(size), bottom + 16, fmt::format("{}", size), "middle");
  }
  svg += Text(kLeft + kWidth / 2, bottom + 34, plot.x_name, "middle");
  for (size_t k = 0; k < plot.series.size(); ++k) {
    const PlotSeries& series = plot.series[k];
    const std::string colour = kColours[k % kColours.size()];
    std::string path;
    for (size_t i = 0; i < plot.sizes.size(); ++i) {
      path += fmt::format("{}{} {}", i == 0 ? "M" : "L", ShortDecimal(x.At(plot.sizes[i])),
                          ShortDecimal(y.At(series.values[i])));
    }
    svg += fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"1.6\" fill=\"none\"/>\n", path, colour);
    for (size_t i = 0; i < series.printed.size(); ++i) {
      svg += fmt::format(
          "<circle cx=\"{}\" cy=\"{}\" r=\"4\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\"/>\n",
          ShortDecimal(x.At(plot.sizes[i])), ShortDecimal(y.At(series.printed[i])), colour);
    }
    svg += Text(right + 4, y.At(series.values.back()) + 4, series.name, "start", colour);
  }
  return svg + "</svg>";
}

}  // namespace tact::provers
