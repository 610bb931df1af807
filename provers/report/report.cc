#include "provers/report/report.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>

#include "algebra/error.h"
#include "provers/report/ledger_json.h"
#include "provers/report/page.h"

namespace tact::provers {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPage = "index.html";
constexpr const char* kLedger = "ledger.json";
constexpr const char* kCertificates = "certificates";

[[noreturn]] void Refuse(const fs::path& path, const std::string& expected, const std::string& got) {
  throw InputError(path.string() + ": expected " + expected + ", got " + got);
}

// The folder's own path, links resolved, so that it can be renamed.
fs::path Resolve(const fs::path& directory) {
  fs::path path = fs::weakly_canonical(fs::absolute(directory));
  if (!path.has_filename()) path = path.parent_path();
  if (!path.has_filename()) Refuse(directory, "a folder for the report", "the root of the file system");
  return path;
}

std::string ReadAll(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The report is made beside its place: the nearest folder above that is there must be one to write in.
void CheckCanWriteBeside(const fs::path& directory) {
  fs::path above = directory.parent_path();
  std::error_code absent;
  while (!fs::exists(above, absent) && above.has_relative_path()) above = above.parent_path();
  const std::string wanted = "a folder to write the report in";
  if (!fs::is_directory(above)) Refuse(above, wanted, "something that is no folder");
  if (access(above.c_str(), W_OK | X_OK) != 0) Refuse(above, wanted, std::strerror(errno));
}

void CheckResolvedPlace(const fs::path& directory) {
  CheckCanWriteBeside(directory);
  const fs::file_status status = fs::status(directory);
  if (!fs::exists(status)) return;
  const std::string wanted =
      "a folder that is empty or holds a report of tact (move it away or name another)";
  if (!fs::is_directory(status)) Refuse(directory, wanted, "something that is no folder");
  if (fs::is_empty(directory)) return;
  if (!fs::is_regular_file(directory / kLedger)) Refuse(directory, wanted, "a folder without ledger.json");
  if (!IsLedgerJson(ReadAll(directory / kLedger))) {
    Refuse(directory, wanted, "a folder whose ledger.json is not tact's");
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    const fs::path name = entry.path().filename();
    if (name != kPage && name != kLedger && name != kCertificates) {
      Refuse(directory, wanted, "a report with something else in it: " + name.string());
    }
  }
}

void WriteFile(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  out.close();
  if (!out) Refuse(path, "to write " + std::to_string(text.size()) + " bytes", std::strerror(errno));
}

// A folder beside another that goes away with this object, whatever it holds by then.
class FolderAside {
 public:
  explicit FolderAside(const fs::path& directory) {
    for (int i = 0; path_.empty(); ++i) {
      const fs::path candidate = directory.parent_path() /
                                 ("." + directory.filename().string() + ".unfinished-" + std::to_string(i));
      if (fs::create_directory(candidate)) path_ = candidate;
    }
  }
  FolderAside(const FolderAside&) = delete;
  FolderAside& operator=(const FolderAside&) = delete;
  ~FolderAside() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// Puts `fresh` in the place of `directory`; what was there is then at `fresh`.
void Exchange(const fs::path& fresh, const fs::path& directory) {
  if (!fs::exists(directory)) {
    fs::rename(fresh, directory);
    return;
  }
  if (renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, directory.c_str(), RENAME_EXCHANGE) == 0) return;
  if (errno != EINVAL && errno != ENOSYS) {
    throw fs::filesystem_error("cannot replace the report", fresh, directory,
                               std::error_code(errno, std::generic_category()));
  }
  // A file system without exchange: the old report waits under another name for a moment.
  const fs::path old = fresh.string() + "-old";
  fs::rename(directory, old);
  fs::rename(fresh, directory);
  fs::rename(old, fresh);
}

}  // namespace

void CheckReportPlace(const fs::path& directory) {
  try {
    CheckResolvedPlace(Resolve(directory));
  } catch (const fs::filesystem_error& error) {
    Refuse(directory, "a folder for the report", error.what());
  }
}

void WriteReport(const std::vector<LedgerEntry>& entries, const fs::path& directory) {
  try {
    const fs::path place = Resolve(directory);
    CheckResolvedPlace(place);
    fs::create_directories(place.parent_path());
    const FolderAside aside(place);
    fs::create_directory(aside.path() / kCertificates);
    for (const LedgerEntry& entry : entries) {
      for (const Certificate& certificate : entry.outcome.certificates) {
        WriteFile(aside.path() / CertificatePath(certificate), certificate.json);
      }
    }
    WriteFile(aside.path() / kPage, ReportPage(entries));
    WriteFile(aside.path() / kLedger, LedgerJson(entries));
    Exchange(aside.path(), place);
  } catch (const fs::filesystem_error& error) {
    Refuse(directory, "a folder for the report", error.what());
  }
}

}  // namespace tact::provers
