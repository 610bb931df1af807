/// @file
/// Standard output, buffered, notes beside it, and files.
/// Errors  InputError: it cannot be written (a full disk, a closed pipe).
#pragma once

#include <string>
#include <string_view>

namespace tact::cli {

class Output {
 public:
  Output() = default;
  /// Writes what is left, silently: the answers before a bad line are answers.
  ~Output();
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text);
  /// Writes what is left.
  void Flush();

 private:
  bool Write();

  std::string buffer_;
};

/// Writes a file that an option names: aside and then in its place, so that none is ever half there; into a device or a
/// pipe as it comes. InputError: it cannot be written.
void WriteFile(const std::string& path, std::string_view text);

/// A line of standard error that is no refusal: what a person should know about the answer.
void Note(std::string_view text);

}  // namespace tact::cli
