#include <vector>

#include "algebra/contact/contact_modes.h"
#include "cli/commands.h"
#include "cli/each_relation.h"

namespace tact::cli {
namespace {

std::string ToJson(const std::vector<std::string>& modes) {
  std::string json = R"({"count":)" + std::to_string(modes.size()) + R"(,"modes":[)";
  for (size_t i = 0; i < modes.size(); ++i) json += (i == 0 ? "\"" : ",\"") + modes[i] + "\"";
  return json + "]}\n";
}

std::string ToList(const std::vector<std::string>& modes) {
  std::string list = std::to_string(modes.size()) + (modes.size() == 1 ? " mode" : " modes") +
                     "; c a contact that is kept, s one that separates, in the order of the contacts\n";
  for (const std::string& mode : modes) list += mode.empty() ? "(no contacts)\n" : mode + "\n";
  return list;
}

}  // namespace

ExitStatus RunModes(const FileOptions& options) {
  AnswerEachRelation(options, [&](const algebra::ContactRelation& relation) {
    const std::vector<std::string> modes = algebra::ContactModes(relation);
    return options.json ? ToJson(modes) : ToList(modes);
  });
  return kAnswered;
}

}  // namespace tact::cli
