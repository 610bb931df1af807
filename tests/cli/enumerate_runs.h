/// @file
/// Runs of `tact enumerate` in folders of their own, also such that are cut short.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/cli/run_program.h"

namespace tact::cli {

using Arguments = std::vector<std::string>;

/// A folder for the runs of a test.
class EnumerateRuns : public ::testing::Test {
 protected:
  explicit EnumerateRuns(std::string what) : what_(std::move(what)) {}

  std::string Folder(const std::string& name) const {
    return std::filesystem::path(beside_.path()).parent_path() / name;
  }
  Answer Run(const Arguments& more) const {
    Arguments arguments = {"enumerate", what_};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunTact(arguments);
  }
  /// Every file of a run and its results, with its bytes.
  std::map<std::string, std::string> Files(const std::string& folder) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(Folder(folder))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream in(entry.path(), std::ios::binary);
      std::ostringstream text;
      text << in.rdbuf();
      files[std::filesystem::relative(entry.path(), Folder(folder))] = text.str();
    }
    return files;
  }

 private:
  std::string what_;
  TemporaryFile beside_{"beside", ""};
};

/// The child's exit status, -1 if it was killed; it may write so many bytes to a file, and runs for so long.
inline int RunLimited(const Arguments& arguments, rlim_t bytes, std::chrono::milliseconds time) {
  std::vector<char*> argv{const_cast<char*>("tact")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    const rlimit limit{bytes, bytes};
    setrlimit(RLIMIT_FSIZE, &limit);
    const int null = open("/dev/null", O_RDWR);
    dup2(null, STDOUT_FILENO);
    dup2(null, STDERR_FILENO);
    execv(TACT_PROGRAM, argv.data());
    _exit(127);
  }
  const auto end = std::chrono::steady_clock::now() + time;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() >= end) kill(child, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace tact::cli
