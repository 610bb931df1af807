#include <fmt/format.h>

#include "provers/claims/joint_claims.h"
#include "provers/claims/prismatic_trials.h"
#include "provers/report/log_plot.h"

namespace tact::provers {
namespace {

constexpr NinePrinted kPrintedA = {{{3.003, 1.649},
                                    {2.384, 1.302},
                                    {2.061, 1.173},
                                    {2.103, 1.173},
                                    {1.787, 1.095},
                                    {1.709, 1.106},
                                    {1.743, 1.154},
                                    {1.690, 1.154},
                                    {1.604, 1.153}}};
constexpr NinePrinted kPrintedB = {{{2.412, 1.261},
                                    {1.689, .8845},
                                    {1.212, .6207},
                                    {1.222, .6029},
                                    {.8123, .4324},
                                    {.5790, .3070},
                                    {.5718, .3063},
                                    {.4148, .2256},
                                    {.2954, .1532}}};

std::vector<PrintedCell> Printed(const std::string& link, const NinePrinted& values) {
  std::vector<PrintedCell> cells;
  for (const int length : kLengths) {
    for (const int poses : kPoseCounts) {
      const PrintedPair& value = values[cells.size()];
      cells.push_back(
          {fmt::format("direction in {}, {} mm, {} poses", link, length, poses), value.mean, value.sd});
    }
  }
  return cells;
}

std::vector<Reading> Readings(Effort effort,
                              const std::vector<std::pair<std::string, PrismaticValue>>& values) {
  std::vector<Reading> readings;
  for (const Placing placing : {Placing::kEqual, Placing::kRandom}) {
    for (const auto& [name, value] : values) {
      Reading& reading = readings.emplace_back();
      reading.name = (placing == Placing::kEqual ? "poses in equal steps" : "poses at random") + name;
      for (const PrismaticCell& cell : PrismaticCellsFor(placing, effort))
        reading.cells.push_back(cell[value]);
    }
  }
  return readings;
}

// Against the number of poses, a line a length.
Figure Plot(const std::string& caption, Effort effort, PrismaticValue value, const NinePrinted& printed) {
  LogPlot plot{caption, "poses", "degrees", {50, 100, 200}, {}};
  const PrismaticCells& nine = PrismaticCellsFor(Placing::kEqual, effort);
  for (size_t l = 0; l < kLengths.size(); ++l) {
    PlotSeries& series = plot.series.emplace_back();
    series.name = fmt::format("{} mm", kLengths[l]);
    for (size_t k = 3 * l; k < 3 * l + 3; ++k) {
      series.values.push_back(nine[k][value].mean);
      series.printed.push_back(printed[k].mean);
    }
  }
  return {caption, DrawLogPlot(plot)};
}

Outcome TryTableB(Effort effort) {
  Outcome outcome = JudgeTable("Table 4.3, direction in B (degrees)", Printed("B", kPrintedB),
                               Readings(effort, {{"", kDirectionB}}));
  outcome.evidence =
      "The heads of Table 4.3 say mm; the numbers are angles in degrees, as those of Table 4.2. Equal steps "
      "from end to end "
      "come nearest; poses at random, whose spread varies, err a little more.";
  outcome.figures = {Plot("Direction in B: lines re-run, rings printed.", effort, kDirectionB, kPrintedB)};
  return outcome;
}

Outcome TryTableA(Effort effort) {
  Outcome outcome = JudgeTable("Table 4.3, direction in A (degrees)", Printed("A", kPrintedA),
                               Readings(effort, {{"", kDirectionA}}));
  outcome.evidence =
      "A's direction is B's, turned by the estimated orientation (4.3). The orientation that (4.6) is least "
      "at averages over "
      "all poses: it errs by little and by less the more poses there are, and so does A's direction, nearly "
      "as little as B's. The "
      "printed errors of A stay near 1.6 degrees however many poses and however long the way. No orientation "
      "that averages over "
      "poses can do that; the first pose's alone, the initial guess, errs more still. "
      "thesis.4.5.2.table-4.3-a-explained names what "
      "fits.";
  outcome.figures = {
      Plot("Direction in A by (4.6): lines re-run, rings printed.", effort, kDirectionA, kPrintedA)};
  return outcome;
}

Outcome TryTableAExplained(Effort effort) {
  Outcome outcome = JudgeTable(
      "Table 4.3, direction in A (degrees)", Printed("A", kPrintedA),
      Readings(effort, {{", pitch alone fitted", kPitchOnlyA}, {", nothing fitted", kFirstPoseA}}));
  outcome.evidence =
      "Of the three angles of (4.26) one, the pitch, is fitted to all poses; yaw and roll stay those of the "
      "first pose, the "
      "initial guess, with its noise. All printed means and SDs agree. Why the search stood still in two of "
      "its three unknowns "
      "the text does not say. So the printed errors of A say nothing about the method: it does up to five "
      "times better.";
  outcome.figures = {Plot("Direction in A, pitch alone fitted: lines re-run, rings printed.", effort,
                          kPitchOnlyA, kPrintedA)};
  return outcome;
}

Outcome TryHarder(Effort effort) {
  Outcome outcome;
  outcome.bound = fmt::format("{} trials a cell", TrialsFor(effort));
  Table table{"A's error less B's of the same trials, degrees, with 95 % intervals (poses in equal steps)",
              {"way", "poses", "B", "A", "A less B"},
              {}};
  const PrismaticCells& nine = PrismaticCellsFor(Placing::kEqual, effort);
  bool harder = true;
  for (size_t i = 0; i < nine.size(); ++i) {
    const PrismaticCell& cell = nine[i];
    const int length = kLengths[i / 3], poses = kPoseCounts[i % 3];
    table.rows.push_back({fmt::format("{} mm", length), std::to_string(poses),
                          WithInterval(cell[kDirectionB]), WithInterval(cell[kDirectionA]),
                          WithInterval(cell[kDifference])});
    if (length == 200) harder = harder && cell[kDifference].mean > HalfWidth(cell[kDifference]);
  }
  outcome.verdict = harder ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.tables = {std::move(table)};
  outcome.evidence =
      "A's direction takes B's over through the estimated orientation, whose error adds. On a way of 200 mm, "
      "where B's own "
      "error is small, the difference is plain; on shorter ones it drowns in B's. It is far smaller than "
      "printed "
      "(thesis.4.5.2.table-4.3-a).";
  return outcome;
}

Outcome TryScaling(Effort effort) {
  const PrismaticCells& nine = PrismaticCellsFor(Placing::kEqual, effort);
  Outcome outcome;
  outcome.bound = fmt::format("{} trials a cell", TrialsFor(effort));
  Table table{"Exponents of B's error, with 95 % intervals", {"against", "at", "exponent"}, {}};
  bool holds = true;
  const auto add = [&](const std::string& against, const std::string& at, const Exponent& exponent,
                       double expected) {
    table.rows.push_back({against, at, ToString(exponent)});
    holds = holds && std::abs(exponent.value - expected) < kAboutExponent + exponent.half_width;
  };
  for (size_t k = 0; k < 3; ++k) {
    add("way, 50 to 200 mm", fmt::format("{} poses", kPoseCounts[k]),
        ExponentBetween(50, nine[k][kDirectionB], 200, nine[6 + k][kDirectionB]), -1);
    add("poses, 50 to 200", fmt::format("{} mm", kLengths[k]),
        ExponentBetween(50, nine[3 * k][kDirectionB], 200, nine[3 * k + 2][kDirectionB]), -0.5);
  }
  outcome.verdict = holds ? Verdict::kReproduced : Verdict::kNotReproduced;
  outcome.tables = {std::move(table)};
  outcome.evidence = fmt::format(
      "Expected are -1 against the way and -1/2 against the number of poses; \"about\" is taken as within "
      "{}. The first pose "
      "and the last lie on the ends of the way, so with few poses a larger share of them is far out: that "
      "makes both slopes a "
      "little flatter than the limit.",
      kAboutExponent);
  return outcome;
}

}  // namespace

std::vector<Claim> PrismaticClaims() {
  return {{"thesis.4.5.2.table-4.3-b",
           "The proposed method finds a prismatic joint's direction in B as Table 4.3 says.",
           "4.5.2, Table 4.3", "simulation", TryTableB},
          {"thesis.4.5.2.table-4.3-a",
           "The proposed method finds a prismatic joint's direction in A as Table 4.3 says.",
           "4.5.2, Table 4.3", "simulation", TryTableA},
          {"thesis.4.5.2.table-4.3-a-explained",
           "Table 4.3's errors of the direction in A are those of an orientation of which the pitch alone "
           "was fitted.",
           "4.5.2, Table 4.3, explained", "simulation", TryTableAExplained},
          {"thesis.4.5.2.a-harder-than-b",
           "A prismatic joint's direction in A is harder to estimate than that in B, for it is estimated "
           "using (4.3).",
           "4.5.2, on Table 4.3", "simulation", TryHarder},
          {"thesis.4.5.2.prismatic-scaling",
           "The error of the direction in B is about inversely proportional to the translation and to the "
           "square root of the "
           "number of poses.",
           "4.5.2, on Table 4.3", "simulation", TryScaling}};
}

}  // namespace tact::provers
