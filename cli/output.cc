#include "cli/output.h"

#include <cstdio>
#include <iostream>

#include "algebra/error.h"

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

void Note(std::string_view text) { std::cerr << "tact: note: " << text << "\n"; }

}  // namespace tact::cli
