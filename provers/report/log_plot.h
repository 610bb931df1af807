/// @file
/// Measured values against a size, both on logarithmic axes: lines for what was re-run, rings for what was printed.
/// Shapes  every series has as many values as there are sizes; all positive.
#pragma once

#include <string>
#include <vector>

namespace tact::provers {

struct PlotSeries {
  std::string name;             // at the line's right end
  std::vector<double> values;   // joined by a line
  std::vector<double> printed;  // rings; none, or as many
};

struct LogPlot {
  std::string title, x_name, y_name;
  std::vector<double> sizes;
  std::vector<PlotSeries> series;
};

/// One <svg> element.
std::string DrawLogPlot(const LogPlot& plot);

}  // namespace tact::provers
