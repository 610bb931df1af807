/// @file
/// Relations of up to eight contacts sorted into DOF classes: how many a second on one thread, and how much faster on two.
/// Model   The whole way of `tact enumerate dof-classes` in memory: units, texts, reading them back, merging. Rounds of
///         one and two threads take turns; the quickest of each counts, since others use the machine, too. Where
///         two threads do not gain, the processor's seconds tell whether that is the machine's doing: they should be equal.
/// Exit    0; 1 if an answer is wrong or a rate asked for is missed.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <stdexcept>
#include <string>

#include "enumerators/dof_class.h"
#include "enumerators/dof_counts_text.h"
#include "enumerators/run_folder.h"

namespace tact::benchmarks {
namespace {

using enumerators::DofCensus;
using enumerators::DofCounts;

struct Options {
  int rounds = 3;
  double rate = 0;     // relations a second on one thread
  double scaling = 0;  // of two threads
};

Options ParseOptions(int argc, char** argv) {
  Options options;
  for (int i = 1; i < argc; i += 2) {
    const std::string name = argv[i];
    const double value = i + 1 < argc ? std::atof(argv[i + 1]) : 0;
    if (name == "--rounds" && value >= 1) {
      options.rounds = static_cast<int>(value);
    } else if (name == "--require" && value > 0) {
      options.rate = value;
    } else if (name == "--require-scaling" && value > 0) {
      options.scaling = value;
    } else {
      throw std::invalid_argument("expected --rounds N, --require RATE or --require-scaling RATIO, got " +
                                  name);
    }
  }
  return options;
}

struct Seconds {
  double wall = 1e300, processor = 1e300;
};

// The quickest of what was and of one more census; its counts.
void Time(const DofCensus& census, size_t threads, Seconds& best, DofCounts& counts) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  enumerators::RunOptions options;
  options.threads = threads;
  RunUnits(
      {"{}", census.units(), [&](size_t unit) { return ToText(census.CountUnit(unit)); }}, options,
      [&](size_t, const std::string& text) { DofCensus::Merge(counts, enumerators::ParseDofCounts(text)); });
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - start;
  best.wall = std::min(best.wall, wall.count());
  best.processor = std::min(best.processor, static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC);
}

bool IsRight(const DofCensus& census, const DofCounts& counts) {
  uint64_t relations = 0;
  std::vector<algebra::MotionDof> dofs;
  for (const enumerators::DofCount& c : counts) {
    relations += c.count;
    dofs.push_back(c.dof);
  }
  return relations == census.relations() && dofs == enumerators::DofClasses();
}

int Run(const Options& options) {
  const DofCensus census(enumerators::CornerWorld(8));
  const double relations = static_cast<double>(census.relations());
  std::printf("%.0f relations of up to %zu of %zu contacts, %zu units\n", relations, census.world().largest,
              census.world().contacts.size(), census.units());
  Seconds one, two;
  bool good = true;
  for (int round = 0; round < options.rounds; ++round) {
    DofCounts first, second;
    Time(census, 1, one, first);
    Time(census, 2, two, second);
    if (first != second || !IsRight(census, first)) {
      std::printf("  the answers differ or are wrong\n");
      good = false;
    }
  }
  const double rate = relations / one.wall, gain = one.wall / two.wall;
  std::printf("1 thread  %8.2f s (%.2f of a processor) %10.0f relations a second\n", one.wall, one.processor,
              rate);
  std::printf("2 threads %8.2f s (%.2f of a processor) %10.0f relations a second, %.2f times as many\n",
              two.wall, two.processor, relations / two.wall, gain);
  const auto require = [&](const char* what, double got, double wanted) {
    if (got >= wanted) return;
    std::printf("  %s is below %.2f\n", what, wanted);
    good = false;
  };
  require("the rate on one thread", rate, options.rate);
  require("the gain of two threads", gain, options.scaling);
  return good ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  try {
    return tact::benchmarks::Run(tact::benchmarks::ParseOptions(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
