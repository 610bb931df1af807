/// @file
/// Tables of simulated averages, printed, against re-runs: cell by cell, under each reading of what the text leaves
/// open.
/// Model   A printed cell is the mean and the standard deviation (SD) over kPrintedTrials trials, a re-run the same
///         over some other number. If both sample one distribution, the difference of the means, over sqrt(sd^2 / n +
///         sd^2 / m), is about standard normal, and so is that of the SDs over their spread, which the re-run's fourth
///         moment gives. A cell agrees if both differences are below kAgrees: 99.99 % of true ones are, each, so that
///         a table of dozens of true cells agrees as a whole.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "provers/ledger.h"

namespace tact::provers {

inline constexpr int kPrintedTrials = 1000;
inline constexpr double kAgrees = 3.89;

struct Moments {
  size_t count = 0;
  double mean = 0, sd = 0;
  double sd_spread = 0;  // of the SD of one sample, times the root of the sample's size, over the SD
};
Moments MomentsOf(std::span<const double> sample);

/// Half the width of the 95 % interval of the mean.
double HalfWidth(const Moments& moments);

/// The nine cells of one quantity: the smallest amount of motion with 50, 100, 200 poses, then the next, then the
/// largest.
struct PrintedPair {
  double mean, sd;
};
using NinePrinted = std::array<PrintedPair, 9>;
inline constexpr std::array kPoseCounts = {50, 100, 200};

struct PrintedCell {
  std::string name;
  double mean = 0, sd = 0;
};

struct Deviation {
  double of_mean = 0, of_sd = 0;  // printed less re-run, standard normal if both agree
  bool agrees() const;
};
Deviation Compare(const PrintedCell& printed, const Moments& rerun);

struct Reading {
  std::string name;
  std::vector<Moments> cells;  // as printed, one for each
};

/// How many cells agree.
int Agreeing(const std::vector<PrintedCell>& printed, const Reading& reading);

/// The index of the reading that most cells agree with; of equals, the one with the smaller sum of squared deviations.
size_t BestReading(const std::vector<PrintedCell>& printed, const std::vector<Reading>& readings);

/// Reproduced if all cells agree with one of the readings; a table of the readings, one of the cells in the best, and
/// numbers.
Outcome JudgeTable(const std::string& caption, const std::vector<PrintedCell>& printed,
                   const std::vector<Reading>& readings);

/// "0.488 +- 0.003": a mean with its 95 % interval.
std::string WithInterval(const Moments& moments);

/// How near an exponent must come for the thesis' "about proportional".
inline constexpr double kAboutExponent = 0.05;

/// The exponent p of y ~ x^p between two sizes, with the half-width of its 95 % interval.
struct Exponent {
  double value = 0, half_width = 0;
};
Exponent ExponentBetween(double x0, const Moments& y0, double x1, const Moments& y1);
std::string ToString(const Exponent& exponent);

}  // namespace tact::provers
