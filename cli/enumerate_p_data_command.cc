#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/output.h"
#include "cli/text_pieces.h"
#include "cli/unit_run.h"
#include "enumerators/code_counts.h"
#include "enumerators/code_transfer.h"

namespace tact::cli {
namespace {

using enumerators::Code;
using enumerators::CodeCounts;

constexpr int kUnitCrossings = 3;    // the codes with so many intersections are the units
constexpr int kMostByTransfer = 20;  // what 64 bits hold
constexpr int kMostUnasked = 17;     // a minute, a gigabyte

int ReadCrossings(const PDataOptions& options) {
  const int most = options.codes ? kMostByTransfer : Code::kMostCrossings;
  if (options.crossings < 0 || options.crossings > most) {
    throw InputError(fmt::format("--crossings: expected 0 to {}{}, got {}", most,
                                 options.codes ? "" : " (with --codes 20)", options.crossings));
  }
  return static_cast<int>(options.crossings);
}

uint64_t PDataOf(uint64_t codes, int crossings) {
  uint64_t p_data = 0;
  if (__builtin_mul_overflow(codes, uint64_t{1} << crossings, &p_data))
    throw InvariantError("a count of P-data does not fit 64 bits");
  return p_data;
}

std::string ToJson(const CodeCounts& c, int crossings) {
  return fmt::format(
      "{{\"crossings\":{},\"codes\":{},\"p_data\":{},\"pairings\":{},\"irreducible\":{{\"codes\":{},\"p_"
      "data\":{}}},"
      "\"up_to_reversal\":{},\"up_to_mirror\":{},\"up_to_both\":{},\"ends_on_one_face\":{}}}\n",
      crossings, c.codes, PDataOf(c.codes, crossings), c.pairings, c.irreducible,
      PDataOf(c.irreducible, crossings), UpToReversal(c), UpToMirror(c), UpToBoth(c), c.ends_on_one_face);
}

std::string ToTable(const std::vector<CodeCounts>& counts) {
  std::string text = fmt::format("{:>2}{:>16}{:>18}{:>14}{:>14}{:>16}{:>16}{:>15}{:>17}\n", "n", "codes",
                                 "P-data", "pairings", "irreducible", "up to reversal", "up to mirror",
                                 "up to both", "ends on one face");
  for (size_t n = 0; n < counts.size(); ++n) {
    const CodeCounts& c = counts[n];
    text += fmt::format("{:>2}{:>16}{:>18}{:>14}{:>14}{:>16}{:>16}{:>15}{:>17}\n", n, c.codes,
                        PDataOf(c.codes, static_cast<int>(n)), c.pairings, c.irreducible, UpToReversal(c),
                        UpToMirror(c), UpToBoth(c), c.ends_on_one_face);
  }
  return text + "Counts but that of the P-data and the pairings are of codes: over and under forgotten.\n";
}

std::string ToJson(const Code& code) {
  const auto row = [&](const Code::Row& numbers) {
    std::string text;
    for (int i = 1; i <= code.columns; ++i)
      text += (i > 1 ? "," : "") + std::to_string(static_cast<int>(numbers[static_cast<size_t>(i)]));
    return text;
  };
  return "{\"sigma\":[" + row(code.sigma) + "],\"turn\":[" + row(code.turn) + "]}\n";
}

void CheckNoRun(const PDataOptions& options, const char* flag) {
  if (options.directory.empty() && options.shard == "1/1" && options.from.empty()) return;
  throw InputError(std::string(flag) + ": expected no -o, --shard or --from with it (nothing is kept)");
}

ExitStatus List(const PDataOptions& options, int crossings) {
  CheckNoRun(options, "--list");
  Output out;
  enumerators::ForEachCode(crossings, [&](const Code& code) { out << ToJson(code); });
  out.Flush();
  return kAnswered;
}

ExitStatus CountByTransfer(const PDataOptions& options, int crossings) {
  CheckNoRun(options, "--codes");
  if (crossings > kMostUnasked && !options.yes) {
    throw InputError(fmt::format(
        "--codes: expected at most {} intersections, got {}: each more takes some three times as long "
        "and as much memory (17: a minute, 500 MB); --yes starts it all the same",
        kMostUnasked, crossings));
  }
  const std::vector<uint64_t> codes =
      enumerators::CountCodesByTransfer(crossings, [&](const enumerators::TransferProgress& at) {
        if (crossings > 14) Note(fmt::format("step {} of {}: {} states", at.layer + 1, at.layers, at.states));
      });
  Output out;
  if (options.json) {
    out << fmt::format("{{\"crossings\":{},\"codes\":{}}}\n", crossings, codes.back());
  } else {
    for (size_t n = 0; n < codes.size(); ++n) out << fmt::format("{:>2}{:>22}\n", n, codes[n]);
  }
  out.Flush();
  return kAnswered;
}

// Seconds a code, by those with six intersections.
double MeasureSeconds() {
  constexpr int kSample = 6;
  const auto start = std::chrono::steady_clock::now();
  const uint64_t codes = enumerators::CountCodes(kSample).back().codes;
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return elapsed.count() / static_cast<double>(codes);
}

ExitStatus CountByKeys(const PDataOptions& options, int crossings) {
  const UnitRunner runner(options);
  const std::vector<uint64_t> by_transfer = enumerators::CountCodesByTransfer(crossings);
  const int grown = std::min(crossings, kUnitCrossings);
  std::vector<Code> units;
  enumerators::ForEachCode(grown, [&](const Code& code) { units.push_back(code); });
  const enumerators::UnitRun run = {
      fmt::format("{{\"kind\":\"p-data\",\"version\":\"{}\",\"crossings\":{},\"units\":{}}}", TACT_VERSION,
                  crossings, units.size()),
      units.size(), [&](size_t unit) { return ToText(enumerators::CountCodesFrom(units[unit], crossings)); }};
  const RunCost cost = {static_cast<double>(by_transfer.back()), "codes", MeasureSeconds};

  std::vector<CodeCounts> counts = enumerators::CountCodes(grown - 1);
  counts.resize(static_cast<size_t>(crossings) + 1);
  const bool all = runner.Run(run, cost, [&](const std::string& text) {
    const std::vector<CodeCounts> more = enumerators::ParseCodeCounts(text);
    if (more.size() != counts.size())
      throw InputError("expected a unit of " + std::to_string(crossings) + " intersections");
    for (size_t n = 0; n < counts.size(); ++n) counts[n] += more[n];
  });
  if (!all) return kAnswered;
  for (size_t n = 0; n < counts.size(); ++n) {
    if (counts[n].codes == by_transfer[n]) continue;
    throw InvariantError(fmt::format("{} codes with {} intersections were visited, by transfer there are {}",
                                     counts[n].codes, n, by_transfer[n]));
  }
  const std::string json = ToJson(counts.back(), crossings);
  if (runner.keeps()) runner.Keep("counts.json", json);
  Output out;
  out << (options.json ? json : ToTable(counts));
  out.Flush();
  return kAnswered;
}

}  // namespace

ExitStatus RunEnumeratePData(const PDataOptions& options) {
  const int crossings = ReadCrossings(options);
  if (options.list) return List(options, crossings);
  return options.codes ? CountByTransfer(options, crossings) : CountByKeys(options, crossings);
}

}  // namespace tact::cli
