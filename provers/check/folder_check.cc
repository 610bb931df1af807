// Files, folders of certificates, and report folders with their ledger.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <set>

#include "provers/check/check.h"
#include "provers/check/json_value.h"

namespace tact::check {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> kVerdicts = {"proved",     "holds to n",     "refuted",
                                                       "reproduced", "not reproduced", "undecided"};

std::optional<std::string> ReadFile(const fs::path& path, Report& report) {
  std::error_code error;
  std::string text;
  if (!fs::exists(path, error)) {
    report.unreadable.push_back(path.string() + ": there is no such file");
  } else if (!fs::is_regular_file(path, error)) {
    report.unreadable.push_back(path.string() + ": not a regular file");
  } else {
    std::ifstream in(path, std::ios::binary);
    text.resize(std::min<std::uintmax_t>(fs::file_size(path, error), kMaxBytes + 1));
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!error && in) return text;
    report.unreadable.push_back(path.string() + ": cannot be read");
  }
  return std::nullopt;
}

// By name below a folder with '/' between, which claim a certificate there names: what a ledger is compared
// with.
using ClaimOfFile = std::map<std::string, std::string>;

void CheckFile(const fs::path& path, Report& report, std::string& claim) {
  const std::optional<std::string> text = ReadFile(path, report);
  if (!text) return;
  const Answer answer = CheckCertificate(*text);
  claim = answer.claim;
  if (answer.accepted) {
    ++report.accepted;
    if (!answer.not_recounted.empty()) report.not_recounted.push_back({path.string(), answer.not_recounted});
  } else {
    report.refused.push_back({path.string(), answer.why});
  }
}

template <typename Iterator>
std::vector<fs::path> JsonFiles(const fs::path& folder, Report& report) {
  std::vector<fs::path> files;
  std::error_code error;
  for (Iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    if (it->path().extension() == ".json" && !it->is_directory(error)) files.push_back(it->path());
  }
  if (error) report.unreadable.push_back(folder.string() + ": " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

void CheckClaim(const Value& claim, const ClaimOfFile& files, std::set<std::string>& ids) {
  const std::string& id = AsString(At(claim, "id"));
  if (!ids.insert(id).second) throw Refused(&At(claim, "id"), Quote(id) + " stands twice");
  const Value& verdict = At(claim, "verdict");
  if (std::find(kVerdicts.begin(), kVerdicts.end(), AsString(verdict)) == kVerdicts.end()) {
    throw Refused(&verdict, "no verdict is called " + Quote(AsString(verdict)));
  }
  const Value* certificates = Find(claim, "certificates");
  const Value* reason = Find(claim, "no_certificate");
  if (certificates != nullptr) {
    for (const Value& name : AsArray(*certificates)) {
      const auto file = files.find(AsString(name));
      if (file == files.end()) throw Refused(&name, "there is no certificate " + Quote(AsString(name)));
      if (!file->second.empty() && file->second != id) {
        throw Refused(&name, Quote(AsString(name)) + " is about the claim " + Quote(file->second) + ", not " +
                                 Quote(id));
      }
    }
  }
  if (certificates != nullptr && !AsArray(*certificates).empty()) return;
  const bool needs_one = AsString(verdict) == "proved" || AsString(verdict) == "refuted";
  if (needs_one && (reason == nullptr || AsString(*reason).empty())) {
    throw Refused(&claim, "the claim " + Quote(id) + " is " + AsString(verdict) +
                              " without a certificate and without a \"no_certificate\" that says why");
  }
}

void CheckLedger(const fs::path& path, const ClaimOfFile& files, Report& report) {
  const std::optional<std::string> text = ReadFile(path, report);
  if (!text) return;
  Value root{nullptr};
  const auto refuse = [&](const Refused& refused) {
    const std::string place = PathOf(root, refused.where());
    report.refused.push_back({path.string(), (place.empty() ? "" : place + ": ") + refused.what()});
  };
  try {
    root = ParseJson(*text);
    std::set<std::string> ids;
    for (const Value& claim : AsArray(At(root, "claims"))) {
      try {
        CheckClaim(claim, files, ids);
      } catch (const Refused& refused) {
        refuse(refused);
      }
    }
  } catch (const Refused& refused) {
    refuse(refused);
  }
}

void CheckReportFolder(const fs::path& folder, Report& report) {
  ClaimOfFile files;
  if (fs::is_directory(folder / "certificates")) {
    for (const fs::path& file :
         JsonFiles<fs::recursive_directory_iterator>(folder / "certificates", report)) {
      CheckFile(file, report, files[file.lexically_relative(folder).generic_string()]);
    }
  }
  if (fs::exists(folder / "ledger.json")) CheckLedger(folder / "ledger.json", files, report);
}

}  // namespace

void CheckPath(const std::string& path, Report& report) {
  std::error_code error;
  const fs::path given(path);
  if (!fs::is_directory(given, error)) {
    std::string claim;
    CheckFile(given, report, claim);
  } else if (fs::is_directory(given / "certificates", error) || fs::exists(given / "ledger.json", error)) {
    CheckReportFolder(given, report);
  } else {
    const std::vector<fs::path> files = JsonFiles<fs::directory_iterator>(given, report);
    if (files.empty()) report.unreadable.push_back(path + ": holds no .json file");
    for (const fs::path& file : files) {
      std::string claim;
      CheckFile(file, report, claim);
    }
  }
}

}  // namespace tact::check
