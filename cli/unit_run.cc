#include "cli/unit_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <thread>

#include "algebra/error.h"
#include "cli/output.h"
#include "enumerators/whole_file.h"
#include "provers/report/text.h"

namespace tact::cli {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr const char* kWork = "work";
constexpr double kMostUnasked = 2e9;   // things
constexpr double kWorthTelling = 2e7;  // things
constexpr long long kMostThreads = 1024;

size_t Cores() { return std::max(1U, std::thread::hardware_concurrency()); }

size_t ReadNumber(std::string_view text, bool& good) {
  size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  good = good && error == std::errc() && end == text.data() + text.size();
  return number;
}

enumerators::Shard ReadShard(const std::string& text) {
  const size_t slash = text.find('/');
  bool good = slash != std::string::npos;
  enumerators::Shard shard;
  if (good) {
    shard.index = ReadNumber(std::string_view(text).substr(0, slash), good);
    shard.count = ReadNumber(std::string_view(text).substr(slash + 1), good);
  }
  if (good && shard.index >= 1 && shard.index <= shard.count) return shard;
  throw InputError("--shard: expected i/n with 1 <= i <= n, got " + text);
}

size_t ReadThreads(long long threads) {
  if (threads >= 1 && threads <= kMostThreads) return static_cast<size_t>(threads);
  throw InputError("--threads: expected 1 to " + std::to_string(kMostThreads) + ", got " +
                   std::to_string(threads));
}

// The results go beside the run: only into a folder that holds nothing else.
void CheckPlace(const fs::path& directory) {
  std::error_code absent, error;
  if (!fs::exists(directory, absent) || fs::exists(directory / kWork, absent)) return;
  const std::string wanted =
      directory.string() + ": expected a folder that is empty or holds a run (name another one), got ";
  if (!fs::is_directory(directory, absent)) throw InputError(wanted + "a file");
  if (!fs::is_empty(directory, error) && !error) throw InputError(wanted + "one that holds something else");
  if (error) throw InputError(wanted + "one that cannot be read: " + error.message());
}

// On a terminal one moving line; elsewhere a line now and then, once it takes long.
class Progress {
 public:
  void operator()(size_t done, size_t total) {
    if (++calls_ == 1) already_ = done - 1;
    const bool terminal = isatty(STDERR_FILENO) == 1;
    if (!terminal && (done == total || Seconds(shown_) < 5)) return;
    if (terminal && done < total && Seconds(shown_) < 0.1) return;
    shown_ = Clock::now();
    const double rest =
        Seconds(started_) * static_cast<double>(total - done) / static_cast<double>(done - already_);
    std::string line = fmt::format("{} of {} units", done, total);
    if (done < total) line += ", about " + provers::ReadableSeconds(rest) + " to go";
    std::fprintf(stderr, terminal ? "\r\033[K%s" : "%s\n", line.c_str());
    if (terminal && done == total) std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
  }

 private:
  static double Seconds(Clock::time_point since) {
    return std::chrono::duration<double>(Clock::now() - since).count();
  }

  const Clock::time_point started_ = Clock::now();
  Clock::time_point shown_ = started_;
  size_t calls_ = 0, already_ = 0;
};

std::string List(const std::vector<size_t>& numbers) {
  std::string text;
  for (const size_t n : numbers) text += (text.empty() ? "" : ",") + std::to_string(n);
  return text;
}

}  // namespace

UnitRunner::UnitRunner(const UnitRunOptions& options) : options_(options) {
  run_options_.shard = ReadShard(options.shard);
  run_options_.threads = options.threads ? ReadThreads(*options.threads) : Cores();
  if (run_options_.shard.count > 1 && options.directory.empty())
    throw InputError("--shard: expected a folder to keep the shard in (-o DIR), got none");
  if (!options.directory.empty()) {
    CheckPlace(options.directory);
    run_options_.folder = fs::path(options.directory) / kWork;
  }
  for (const std::string& from : options.from) {
    std::error_code absent;
    if (!fs::is_directory(fs::path(from) / kWork, absent))
      throw InputError(from + ": expected the folder of a run (with a folder work in it), got none");
    run_options_.sources.push_back(fs::path(from) / kWork);
  }
}

void UnitRunner::TellCost(const RunCost& cost) const {
  const double things = cost.things / static_cast<double>(run_options_.shard.count);
  if (things < kWorthTelling) return;
  const size_t threads = std::min(run_options_.threads, Cores());
  const std::string estimate =
      fmt::format("{} {}, about {} on {} thread{}", fmt::format("{:.3g}", things), cost.noun,
                  provers::ReadableSeconds(things * cost.measure() / static_cast<double>(threads)), threads,
                  threads == 1 ? "" : "s");
  if (things > kMostUnasked && !options_.yes) {
    throw InputError(
        fmt::format("expected a run of at most {:.3g} {}, got {}; --yes starts it all the same, "
                    "--shard i/n a part of it",
                    kMostUnasked, cost.noun, estimate));
  }
  Note(estimate + (keeps() ? "; what is done stays if the run is interrupted"
                           : "; with -o DIR what is done would stay if the run is interrupted"));
}

bool UnitRunner::Run(const enumerators::UnitRun& run, const RunCost& cost,
                     const std::function<void(const std::string&)>& take) const {
  TellCost(cost);
  enumerators::RunOptions run_options = run_options_;
  Progress progress;
  run_options.progress = std::ref(progress);
  const std::vector<size_t> missing =
      enumerators::RunUnits(run, run_options, [&](size_t, const std::string& text) { take(text); });
  if (!missing.empty()) TellMissing(run, missing);
  return missing.empty();
}

void UnitRunner::TellMissing(const enumerators::UnitRun& run, const std::vector<size_t>& missing) const {
  const size_t shards = run_options_.shard.count;
  const std::string list = List(enumerators::ShardsOf(missing, shards));
  Output out;
  if (options_.json) {
    out << fmt::format(
        "{{\"shard\":{},\"shards\":{},\"missing_shards\":[{}],\"missing_units\":{},\"units\":{}}}\n",
        run_options_.shard.index, shards, list, missing.size(), run.units);
  } else {
    out << fmt::format(
        "Shard {} of {} is done and kept in {}. Missing: {} of {} units, in shards {} of {}.\n",
        run_options_.shard.index, shards, options_.directory, missing.size(), run.units, list, shards);
  }
  out.Flush();
}

void UnitRunner::Keep(const std::string& name, const std::string& text) const {
  enumerators::WriteWhole(fs::path(options_.directory) / name, text, run_options_.folder);
}

}  // namespace tact::cli
