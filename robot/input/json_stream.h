/// @file
/// JSON values from a file: one a line (JSON lines), or a single one over many lines.
/// Model   If the first line that is not blank is a complete value, each line is one; otherwise the whole
/// text is. Errors  InputError: what JsonDocument refuses; a file that cannot be opened or read; nothing but
/// blanks. Cost    JSON lines: the memory of one line.
#pragma once

#include <fstream>
#include <istream>
#include <optional>
#include <string>

#include "robot/input/json_value.h"

namespace tact::input {

/// A file opened for reading, or standard input for "-".
class InputFile {
 public:
  /// InputError: it cannot be opened, or is a folder.
  explicit InputFile(const std::string& path);
  std::istream& stream();
  /// The path, or "<stdin>".
  const std::string& name() const { return name_; }

 private:
  std::string name_;
  std::ifstream file_;
};

class JsonStream {
 public:
  JsonStream(std::istream& in, std::string source) : in_(in), source_(std::move(source)) {}

  /// The next value; nullopt at the end. The first call refuses a text of nothing but blanks.
  std::optional<JsonDocument> Next();
  /// Whether another value (or a line that is none) follows; reads up to it.
  bool HasMore();

 private:
  bool ReadLine();
  JsonDocument ParseFirst();

  std::istream& in_;
  std::string source_;
  std::string line_;        // the next line that is not blank, if has_line_
  size_t line_number_ = 0;  // of line_, from 1
  bool has_line_ = false;
  bool started_ = false;
};

/// The whole file as a single value.
JsonDocument ReadJsonFile(const std::string& path);

}  // namespace tact::input
