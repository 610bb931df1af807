#include "cli/png_file.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>

#include "algebra/error.h"
#include "enumerators/whole_file.h"

extern char** environ;

namespace tact::cli {
namespace {

namespace fs = std::filesystem;

// A file that goes when the object does.
class Aside {
 public:
  explicit Aside(fs::path path) : path_(std::move(path)) {}
  ~Aside() {
    std::error_code absent;
    fs::remove(path_, absent);
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

}  // namespace

void WritePng(const fs::path& path, const std::string& svg) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const std::string stem = path.filename().string() + "." + std::to_string(getpid());
  const Aside source(folder / (stem + ".svg.part")), picture(folder / (stem + ".png.part"));
  enumerators::WriteWhole(source.path(), svg, folder);
  std::string to = picture.path(), from = source.path();
  std::array<std::string, 7> words = {"rsvg-convert", "--background-color", "white", "--format",
                                      "png",          "--output=" + to,     from};
  std::array<char*, 8> argv{};
  for (size_t i = 0; i < words.size(); ++i) argv[i] = words[i].data();
  pid_t child = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0)
    throw InputError(
        path.string() +
        ": expected rsvg-convert to make a PNG (apt-get install librsvg2-bin), got no such program");
  int status = 0;
  waitpid(child, &status, 0);
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    throw InputError(path.string() + ": expected rsvg-convert to make a PNG, got that it failed");
  std::error_code error;
  fs::rename(picture.path(), path, error);
  if (error) throw InputError(path.string() + ": cannot be written: " + error.message());
}

}  // namespace tact::cli
