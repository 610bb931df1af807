#include "provers/report/ledger_json.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace tact::provers {
namespace {

using nlohmann::ordered_json;

constexpr const char* kFormat = "tact-ledger";

ordered_json EntryJson(const LedgerEntry& entry) {
  const Outcome& outcome = entry.outcome;
  ordered_json numbers = ordered_json::object();
  for (const auto& [name, value] : outcome.numbers) numbers[name] = value;
  ordered_json certificates = ordered_json::array();
  for (const Certificate& certificate : outcome.certificates)
    certificates.push_back(CertificatePath(certificate));
  ordered_json json = {
      {"id", entry.claim.id},         {"statement", entry.claim.statement},
      {"source", entry.claim.source}, {"method", entry.claim.method},
      {"bound", outcome.bound},       {"verdict", ToString(outcome.verdict)},
      {"evidence", outcome.evidence}, {"numbers", numbers},
      {"certificates", certificates},
  };
  const bool decided = outcome.verdict == Verdict::kProved || outcome.verdict == Verdict::kRefuted;
  if (decided && outcome.certificates.empty()) json["no_certificate"] = outcome.no_certificate;
  json["seconds"] = std::round(entry.seconds * 1e6) / 1e6;
  return json;
}

}  // namespace

std::string LedgerJson(const std::vector<LedgerEntry>& entries) {
  ordered_json claims = ordered_json::array();
  for (const LedgerEntry& entry : entries) claims.push_back(EntryJson(entry));
  const ordered_json ledger = {{"format", kFormat}, {"version", 1}, {"claims", claims}};
  return ledger.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

bool IsLedgerJson(std::string_view text) {
  const auto ledger = nlohmann::json::parse(text, nullptr, false);
  if (!ledger.is_object()) return false;
  const auto format = ledger.find("format"), claims = ledger.find("claims");
  return format != ledger.end() && *format == kFormat && claims != ledger.end() && claims->is_array();
}

std::string CertificatePath(const Certificate& certificate) {
  return "certificates/" + certificate.name + ".json";
}

}  // namespace tact::provers
