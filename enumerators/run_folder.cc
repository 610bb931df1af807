#include "enumerators/run_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <exception>
#include <mutex>
#include <optional>
#include <set>
#include <system_error>
#include <thread>

#include "algebra/error.h"
#include "enumerators/whole_file.h"

namespace tact::enumerators {
namespace {

namespace fs = std::filesystem;

constexpr const char* kRun = "run.json";
constexpr const char* kUnits = "units";
constexpr std::string_view kEnd = "\n}\n";

std::string RunText(const UnitRun& run) {
  return R"({"format":"tact-run","version":1,"units":)" + std::to_string(run.units) + ",\"run\":\n" +
         run.description + std::string(kEnd);
}

std::string OneLine(std::string text) {
  constexpr size_t kLongest = 400;
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() > kLongest) text = text.substr(0, kLongest) + "...";
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

// Holds a folder as long as it lives: alone at first if nobody else holds it, so that one may tidy up, then shared.
// Where locks do not exist nobody is alone, and nothing is tidied up.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& folder)
      : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0)
      throw InputError(folder.string() + ": expected a folder, got: " + std::strerror(errno));
    alone_ = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (!alone_) Share();
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() { close(descriptor_); }

  bool alone() const { return alone_; }
  void Share() {
    while (flock(descriptor_, LOCK_SH) != 0 && errno == EINTR) continue;
  }

 private:
  int descriptor_;
  bool alone_ = false;
};

// The texts of a run's units as files.
class UnitFiles {
 public:
  UnitFiles(const UnitRun& run, fs::path folder)
      : run_text_(RunText(run)), digest_(Digest(run_text_)), folder_(std::move(folder)) {}

  // A folder that is there and holds this run, to read from.
  void CheckHoldsRun() const {
    const std::optional<std::string> text = ReadWhole(folder_ / kRun);
    if (!text) throw InputError(folder_.string() + ": expected the folder of a run, got one without " + kRun);
    if (*text == run_text_) return;
    throw InputError((folder_ / kRun).string() + ": expected the run " + OneLine(run_text_) +
                     ", got another one: " + OneLine(*text) + "; name another folder for this run");
  }

  // Makes the folder this run's, or checks that it is.
  void Claim(bool alone) const {
    if (!fs::exists(folder_ / kRun)) {
      for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        if (IsAside(entry.path())) continue;
        throw InputError(folder_.string() + ": expected an empty folder or a run, got a folder that holds " +
                         entry.path().filename().string() + "; name another folder");
      }
      WriteWhole(folder_ / kRun, run_text_, folder_);
    }
    CheckHoldsRun();
    MakeFolder(folder_ / kUnits);
    FlushFolder(folder_);
    if (!alone) return;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
      std::error_code ignored;
      if (IsAside(entry.path())) fs::remove(entry.path(), ignored);
    }
  }

  std::optional<std::string> Read(size_t unit) const {
    const std::optional<std::string> file = ReadWhole(PathOf(unit));
    if (!file) return std::nullopt;
    const size_t head = Head(unit, "").size();  // digests are of one length
    if (file->size() < head + kEnd.size()) return std::nullopt;
    std::string text = file->substr(head, file->size() - head - kEnd.size());
    if (*file != FileText(unit, text)) return std::nullopt;
    return text;
  }
  void Write(size_t unit, const std::string& text) const {
    WriteWhole(PathOf(unit), FileText(unit, text), folder_);
  }
  void Flush() const { FlushFolder(folder_ / kUnits); }
  fs::path PathOf(size_t unit) const { return folder_ / kUnits / (std::to_string(unit) + ".json"); }

 private:
  std::string Head(size_t unit, std::string_view text) const {
    return R"({"unit":)" + std::to_string(unit) + R"(,"run":")" + digest_ + R"(","digest":")" + Digest(text) +
           "\",\"result\":\n";
  }
  std::string FileText(size_t unit, std::string_view text) const {
    return Head(unit, text).append(text).append(kEnd);
  }

  std::string run_text_, digest_;
  fs::path folder_;
};

// Where texts go: files, or memory.
class UnitStore {
 public:
  UnitStore(const UnitRun& run, const fs::path& folder) {
    if (folder.empty()) {
      memory_.resize(run.units);
      return;
    }
    MakeFolder(folder);
    files_.emplace(run, folder);
    lock_.emplace(folder);
    files_->Claim(lock_->alone());
    lock_->Share();
  }

  std::optional<std::string> Read(size_t unit) const { return files_ ? files_->Read(unit) : memory_[unit]; }
  // Different units on different threads.
  void Write(size_t unit, const std::string& text) {
    if (files_) {
      files_->Write(unit, text);
    } else {
      memory_[unit] = text;
    }
  }
  void Flush() const {
    if (files_) files_->Flush();
  }

 private:
  std::vector<std::optional<std::string>> memory_;
  std::optional<UnitFiles> files_;
  std::optional<FolderLock> lock_;
};

// Computes the units on this thread and others, each once; the first exception ends all.
class Workers {
 public:
  Workers(const UnitRun& run, const RunOptions& options, UnitStore& store, std::vector<size_t> units,
          size_t done)
      : run_(run),
        options_(options),
        store_(store),
        units_(std::move(units)),
        total_(done + units_.size()),
        done_(done) {}

  void Run() {
    std::vector<std::thread> helpers;
    try {
      while (helpers.size() + 1 < std::min(options_.threads, units_.size()))
        helpers.emplace_back([this] { Work(); });
    } catch (const std::system_error&) {  // the system gives no more threads: those there are will do
    }
    Work();
    for (std::thread& helper : helpers) helper.join();
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void Work() {
    try {
      for (size_t i; (i = next_++) < units_.size();) {
        store_.Write(units_[i], run_.compute(units_[i]));
        const std::lock_guard lock(mutex_);
        ++done_;
        if (options_.progress) options_.progress(done_, total_);
      }
    } catch (...) {
      next_ = units_.size();
      const std::lock_guard lock(mutex_);
      if (!error_) error_ = std::current_exception();
    }
  }

  const UnitRun& run_;
  const RunOptions& options_;
  UnitStore& store_;
  const std::vector<size_t> units_;
  const size_t total_;
  std::atomic<size_t> next_ = 0;
  std::mutex mutex_;
  size_t done_;
  std::exception_ptr error_;
};

void TakeOver(const UnitRun& run, const fs::path& source, UnitStore& store, std::set<size_t>& missing) {
  const UnitFiles files(run, source);
  files.CheckHoldsRun();
  for (auto unit = missing.begin(); unit != missing.end();) {
    const std::optional<std::string> text = files.Read(*unit);
    if (text) store.Write(*unit, *text);
    unit = text ? missing.erase(unit) : std::next(unit);
  }
}

}  // namespace

std::vector<size_t> RunUnits(const UnitRun& run, const RunOptions& options,
                             const std::function<void(size_t, const std::string&)>& take) try {
  const Shard shard = options.shard;
  if (shard.index < 1 || shard.index > shard.count) {
    throw PreconditionError("no shard " + std::to_string(shard.index) + " of " + std::to_string(shard.count));
  }
  if (options.threads < 1) throw PreconditionError("a run needs a thread");
  UnitStore store(run, options.folder);
  std::set<size_t> missing;
  for (size_t unit = 0; unit < run.units; ++unit) {
    if (!store.Read(unit)) missing.insert(missing.end(), unit);
  }
  for (const fs::path& source : options.sources) TakeOver(run, source, store, missing);

  std::vector<size_t> ours, others;
  for (const size_t unit : missing) (shard.Has(unit) ? ours : others).push_back(unit);
  const size_t all_ours = run.units / shard.count + (shard.index <= run.units % shard.count ? 1 : 0);
  Workers(run, options, store, ours, all_ours - ours.size()).Run();
  store.Flush();
  std::erase_if(others, [&](size_t unit) { return store.Read(unit).has_value(); });  // of another process
  if (!others.empty()) return others;
  for (size_t unit = 0; unit < run.units; ++unit) {
    const std::optional<std::string> text = store.Read(unit);
    if (!text) {
      throw InputError(options.folder.string() + ": expected unit " + std::to_string(unit) +
                       " where it was put, got none; run the same command again");
    }
    take(unit, *text);
  }
  return {};
} catch (const fs::filesystem_error& error) {
  throw InputError(options.folder.string() + ": expected a folder for a run, got: " + error.what());
}

std::vector<size_t> ShardsOf(const std::vector<size_t>& units, size_t shards) {
  std::set<size_t> numbers;
  for (const size_t unit : units) numbers.insert(unit % shards + 1);
  return {numbers.begin(), numbers.end()};
}

std::string Digest(std::string_view text) {
  uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  std::string digits(16, '0');
  for (size_t i = 16; i-- > 0; hash >>= 4) digits[i] = "0123456789abcdef"[hash & 15];
  return digits;
}

}  // namespace tact::enumerators
