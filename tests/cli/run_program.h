/// @file
/// Runs the built `tact` as a person would.
#pragma once

#include <string>
#include <vector>

namespace tact::cli {

struct Answer {
  int status = -1;  // exit status; -1 if it ended by a signal
  std::string out;
  std::string err;
};

/// `tact arguments...` with `input` on its standard input. Nothing is read by a shell.
Answer RunTact(const std::vector<std::string>& arguments, const std::string& input = "");

/// A file in a folder of its own that ends with the object.
class TemporaryFile {
 public:
  TemporaryFile(const std::string& name, const std::string& text);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string folder_;
  std::string path_;
};

}  // namespace tact::cli
