/// @file
/// Plots of numbers over an abscissa, as SVG: no ids and no style sheet.
/// Units   pixels; the caller's numbers carry theirs in the labels.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace tact::provers {

enum class PlotMark { kLine, kDots, kCrosses };

struct PlotSeries {
  std::string name;  // for the legend; empty: none
  std::string colour;
  PlotMark mark = PlotMark::kDots;
  std::vector<std::pair<double, double>> points;  // finite
};

struct Plot {
  std::string title;  // for those who cannot see it
  std::string x_label, y_label;
  std::vector<PlotSeries> series;
  std::vector<std::pair<double, double>> bands;  // shaded from the first to the second ordinate
  double width = 680, height = 220;
};

/// Round numbers, at most about `count`, that cover [low, high].
std::vector<double> Ticks(double low, double high, int count);

std::string DrawPlot(const Plot& plot);

}  // namespace tact::provers
