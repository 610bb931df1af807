#include <chrono>
#include <sstream>

#include "algebra/error.h"
#include "cli/commands.h"
#include "cli/knot_inputs.h"
#include "cli/output.h"
#include "cli/tying_page.h"
#include "cli/tying_text.h"

namespace tact::cli {
namespace {

knot::MoveRules ReadRules(const KnotOptions& options) {
  knot::MoveRules rules{false, false, false, false};
  std::istringstream words(options.moves + ",");  // so that nothing is one empty word
  for (std::string word; std::getline(words, word, ',');) {
    bool* const allowed = word == "R1"      ? &rules.r1
                          : word == "R2"    ? &rules.r2
                          : word == "R3"    ? &rules.r3
                          : word == "Cross" ? &rules.cross
                                            : nullptr;
    if (allowed == nullptr) {
      throw InputError("--moves: expected some of R1, R2, R3 and Cross set apart by commas, got '" + word +
                       "'");
    }
    *allowed = true;
  }
  if (options.hold == "selective") {
    rules.held = knot::RopeEnd::kSelective;
  } else if (options.hold == "other") {
    rules.held = knot::RopeEnd::kOther;
  } else if (!options.hold.empty()) {
    throw InputError("--hold: expected selective or other, got '" + options.hold + "'");
  }
  return rules;
}

int ReadLimit(const KnotOptions& options) {
  if (!options.limit) return INT_MAX;
  if (*options.limit < 0 || *options.limit > 1000000)
    throw InputError("--limit: expected 0 to 1000000 steps, got " + std::to_string(*options.limit));
  return static_cast<int>(*options.limit);
}

}  // namespace

ExitStatus RunKnotTie(const KnotOptions& options) {
  knot::TyingOptions tying_options;
  tying_options.rules = ReadRules(options);
  tying_options.limit = ReadLimit(options);
  const auto start = std::chrono::steady_clock::now();
  tying_options.progress = [start](int length, size_t states) {
    if (std::chrono::steady_clock::now() - start < std::chrono::seconds(1)) return;
    Note("trying " + std::to_string(length) + " steps, " + std::to_string(states) + " P-data so far");
  };
  const knot::PData knot = ReadPlanarKnots(options)[0];
  const knot::Tying tying = TieShortest(knot, tying_options);
  if (!options.output.empty()) WriteTyingFolder(tying, options.inputs.front(), options.output);
  Output out;
  out << (options.json ? TyingToJson(tying) : TyingToText(tying));
  out.Flush();
  return kAnswered;
}

}  // namespace tact::cli
