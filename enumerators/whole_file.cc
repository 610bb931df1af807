#include "enumerators/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include "algebra/error.h"

namespace tact::enumerators {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kAside = ".aside-";

[[noreturn]] void Refuse(const fs::path& path, const std::string& expected, int error) {
  throw InputError(path.string() + ": expected " + expected + ", got: " + std::strerror(error));
}

// A new file of its own name; gone with this object unless it was put in place.
class AsideFile {
 public:
  explicit AsideFile(const fs::path& folder) {
    static std::atomic<unsigned> last = 0;
    do {
      path_ = folder / (std::string(kAside) + std::to_string(getpid()) + "-" + std::to_string(++last));
      file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    } while (file_ < 0 && errno == EEXIST);
    if (file_ < 0) Refuse(folder, "a folder to write in", errno);
  }
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;
  ~AsideFile() {
    if (file_ >= 0) close(file_);
    if (!path_.empty()) unlink(path_.c_str());
  }

  // Zero, or the system's error.
  int Write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(file_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return errno;
      text.remove_prefix(static_cast<size_t>(written));
    }
    if (fsync(file_) != 0 && errno != EINVAL) return errno;  // EINVAL: nothing to flush to
    const int closed = close(file_);
    file_ = -1;
    return closed == 0 ? 0 : errno;
  }
  int PutInPlace(const fs::path& path) {
    if (std::rename(path_.c_str(), path.c_str()) != 0) return errno;
    path_.clear();
    return 0;
  }

 private:
  std::string path_;
  int file_ = -1;
};

}  // namespace

void WriteWhole(const fs::path& path, const std::string& text, const fs::path& aside) {
  AsideFile file(aside);
  int error = file.Write(text);
  if (error == 0) error = file.PutInPlace(path);
  if (error != 0) Refuse(path, "to write " + std::to_string(text.size()) + " bytes", error);
}

bool IsAside(const fs::path& path) { return path.filename().string().rfind(kAside, 0) == 0; }

std::optional<std::string> ReadWhole(const fs::path& path) {
  std::error_code absent;
  if (!fs::exists(path, absent)) return std::nullopt;
  if (fs::is_directory(path, absent)) Refuse(path, "a file", EISDIR);
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (!in) Refuse(path, "a readable file", errno);
  return text;
}

void MakeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) Refuse(folder, "a folder that can be made", error.value());
  if (!fs::is_directory(folder, error)) Refuse(folder, "a folder", ENOTDIR);
}

void FlushFolder(const fs::path& folder) {
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  fsync(descriptor);  // some file systems cannot: then their names are as safe as they get
  close(descriptor);
}

}  // namespace tact::enumerators
