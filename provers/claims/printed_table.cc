#include "provers/claims/printed_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tact::provers {
namespace {

constexpr double k95 = 1.96;

double SumOfSquares(const std::vector<PrintedCell>& printed, const Reading& reading) {
  double sum = 0;
  for (size_t i = 0; i < printed.size(); ++i) {
    const Deviation d = Compare(printed[i], reading.cells[i]);
    sum += d.of_mean * d.of_mean + d.of_sd * d.of_sd;
  }
  return sum;
}

double Largest(const std::vector<PrintedCell>& printed, const Reading& reading) {
  double largest = 0;
  for (size_t i = 0; i < printed.size(); ++i) {
    const Deviation d = Compare(printed[i], reading.cells[i]);
    largest = std::max({largest, std::abs(d.of_mean), std::abs(d.of_sd)});
  }
  return largest;
}

}  // namespace

Moments MomentsOf(std::span<const double> sample) {
  const auto n = static_cast<double>(sample.size());
  double mean = 0, second = 0, fourth = 0;
  for (const double x : sample) mean += x / n;
  for (const double x : sample) {
    const double square = (x - mean) * (x - mean);
    second += square / n;
    fourth += square * square / n;
  }
  if (second == 0) return {sample.size(), mean, 0, 0};
  return {sample.size(), mean, std::sqrt(second * n / (n - 1)),
          std::sqrt(std::max(0.0, fourth / (second * second) - 1) / 4)};
}

double HalfWidth(const Moments& moments) {
  return k95 * moments.sd / std::sqrt(static_cast<double>(moments.count));
}

bool Deviation::agrees() const { return std::abs(of_mean) < kAgrees && std::abs(of_sd) < kAgrees; }

Deviation Compare(const PrintedCell& printed, const Moments& rerun) {
  const double root = std::sqrt(1.0 / kPrintedTrials + 1 / static_cast<double>(rerun.count));
  return {(printed.mean - rerun.mean) / (rerun.sd * root),
          (printed.sd - rerun.sd) / (rerun.sd * rerun.sd_spread * root)};
}

int Agreeing(const std::vector<PrintedCell>& printed, const Reading& reading) {
  int count = 0;
  for (size_t i = 0; i < printed.size(); ++i) count += Compare(printed[i], reading.cells[i]).agrees();
  return count;
}

size_t BestReading(const std::vector<PrintedCell>& printed, const std::vector<Reading>& readings) {
  size_t best = 0;
  for (size_t i = 1; i < readings.size(); ++i) {
    const int more = Agreeing(printed, readings[i]) - Agreeing(printed, readings[best]);
    if (more > 0 ||
        (more == 0 && SumOfSquares(printed, readings[i]) < SumOfSquares(printed, readings[best]))) {
      best = i;
    }
  }
  return best;
}

std::string WithInterval(const Moments& moments) {
  return fmt::format("{:.4f} \u00b1 {:.4f}", moments.mean, HalfWidth(moments));
}

Outcome JudgeTable(const std::string& caption, const std::vector<PrintedCell>& printed,
                   const std::vector<Reading>& readings) {
  const size_t chosen = BestReading(printed, readings);
  const Reading& best = readings[chosen];
  const int agreeing = Agreeing(printed, best);
  const size_t trials = best.cells.front().count;
  Outcome outcome;
  outcome.verdict =
      agreeing == static_cast<int>(printed.size()) ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.bound = fmt::format("{} trials a cell, {} printed ones", trials, kPrintedTrials);
  outcome.numbers = {{"trials a cell", static_cast<long long>(trials)},
                     {"readings", static_cast<long long>(readings.size())},
                     {"cells", static_cast<long long>(printed.size())},
                     {"cells that agree with the best reading", agreeing}};
  Table by_reading{
      caption + ": readings, and how many of the " + std::to_string(printed.size()) + " cells agree",
      {"reading", "cells that agree", "largest deviation", "mean square deviation"},
      {}};
  for (size_t i = 0; i < readings.size(); ++i) {
    by_reading.rows.push_back({readings[i].name + (i == chosen ? " (best)" : ""),
                               std::to_string(Agreeing(printed, readings[i])),
                               fmt::format("{:.1f}", Largest(printed, readings[i])),
                               fmt::format("{:.2f}", SumOfSquares(printed, readings[i]) /
                                                         (2 * static_cast<double>(printed.size())))});
  }
  Table by_cell{caption + ", re-run: " + best.name + "; mean with its 95 % interval, SD in brackets",
                {"cell", "printed", "re-run", "deviation of the mean", "of the SD", "agrees"},
                {}};
  for (size_t i = 0; i < printed.size(); ++i) {
    const Deviation deviation = Compare(printed[i], best.cells[i]);
    by_cell.rows.push_back({printed[i].name, fmt::format("{} ({})", printed[i].mean, printed[i].sd),
                            fmt::format("{} ({:.4f})", WithInterval(best.cells[i]), best.cells[i].sd),
                            fmt::format("{:+.1f}", deviation.of_mean),
                            fmt::format("{:+.1f}", deviation.of_sd), deviation.agrees() ? "yes" : "no"});
  }
  outcome.tables = {std::move(by_reading), std::move(by_cell)};
  return outcome;
}

Exponent ExponentBetween(double x0, const Moments& y0, double x1, const Moments& y1) {
  const double scale = std::log(x1 / x0);
  const double relative0 = HalfWidth(y0) / y0.mean, relative1 = HalfWidth(y1) / y1.mean;
  return {std::log(y1.mean / y0.mean) / scale,
          std::sqrt(relative0 * relative0 + relative1 * relative1) / std::abs(scale)};
}

std::string ToString(const Exponent& exponent) {
  return fmt::format("{:.3f} \u00b1 {:.3f}", exponent.value, exponent.half_width);
}

}  // namespace tact::provers
