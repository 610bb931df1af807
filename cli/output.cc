#include "cli/output.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "algebra/error.h"
#include "enumerators/whole_file.h"

namespace tact::cli {
namespace {

constexpr size_t kBlock = 1 << 16;  // bytes

}  // namespace

Output::~Output() { Write(); }

bool Output::Write() {
  const bool written = std::fwrite(buffer_.data(), 1, buffer_.size(), stdout) == buffer_.size();
  buffer_.clear();
  return std::fflush(stdout) == 0 && written;
}

Output& Output::operator<<(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= kBlock) Flush();
  return *this;
}

void Output::Flush() {
  if (!Write()) throw InputError("standard output: expected to write the answer, got an error of the system");
}

void WriteFile(const std::string& path, std::string_view text) {
  namespace fs = std::filesystem;
  const fs::path file(path);
  std::error_code none;
  if (fs::exists(file, none) && !fs::is_regular_file(file, none)) {
    std::ofstream stream(file, std::ios::binary);
    stream << text;
    if (!stream.flush()) throw InputError(path + ": expected a file that can be written");
    return;
  }
  enumerators::WriteWhole(file, std::string(text), file.has_parent_path() ? file.parent_path() : ".");
}

void Note(std::string_view text) { std::cerr << "tact: note: " << text << "\n"; }

}  // namespace tact::cli
