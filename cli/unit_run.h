/// @file
/// What the enumerations share: arguments of a run in units, its cost before it starts, progress, and what is missing.
/// Folder  DIR/work is the run (enumerators/run_folder.h); results stand beside it in DIR once all units are there.
/// Errors  InputError: arguments that make no sense, a folder of something else, a cost beyond what is started unasked.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.h"
#include "enumerators/run_folder.h"

namespace tact::cli {

/// What a run costs, to be told, or refused, before it starts.
struct RunCost {
  double things = 0;                // in the whole run
  std::string noun;                 // "relations"
  std::function<double()> measure;  // seconds a thing on one thread, measured on a few thousand
};

class UnitRunner {
 public:
  /// Checks the arguments and the folder; nothing is written yet.
  explicit UnitRunner(const UnitRunOptions& options);

  /// Computes what is missing of the shard and calls take(unit, text) for every unit if all are there: true. Otherwise
  /// says on standard output which shards are missing: false.
  bool Run(const enumerators::UnitRun& run, const RunCost& cost,
           const std::function<void(const std::string& text)>& take) const;

  /// Whether results are kept.
  bool keeps() const { return !options_.directory.empty(); }
  /// Writes a file of results beside the run.
  void Keep(const std::string& name, const std::string& text) const;

 private:
  void TellCost(const RunCost& cost) const;
  void TellMissing(const enumerators::UnitRun& run, const std::vector<size_t>& missing) const;

  const UnitRunOptions& options_;
  enumerators::RunOptions run_options_;
};

}  // namespace tact::cli
