#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace tact::cli {
namespace {

const std::string kRoot = TACT_SOURCE_DIR;

struct Example {
  std::string command, output;
};

// The indented lines of the README that start with "$ " are commands; what follows them, up to the next command or the
// end of the indentation, is what they print.
std::vector<Example> ExamplesOfReadme() {
  std::ifstream readme(kRoot + "/README.md");
  std::vector<Example> examples;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    if (line.rfind("    $ ", 0) == 0) {
      examples.push_back({line.substr(6), ""});
      inside = true;
    } else if (inside && line.rfind("    ", 0) == 0) {
      examples.back().output += line.substr(4) + "\n";
    } else {
      inside = false;
    }
  }
  return examples;
}

// As typed at the repository's root, with the built program in place of ./tact, which adds nothing to it.
std::string OutputOf(std::string command) {
  for (size_t at; (at = command.find("./tact ")) != std::string::npos;) command.replace(at, 6, TACT_PROGRAM);
  FILE* pipe = popen(("cd '" + kRoot + "' && " + command).c_str(), "r");
  std::string output;
  for (int c; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
  pclose(pipe);
  return output;
}

TEST(Readme, ShowsWhatTheProgramPrints) {
  const auto examples = ExamplesOfReadme();
  ASSERT_GE(examples.size(), 5U);
  for (const Example& example : examples)
    EXPECT_EQ(OutputOf(example.command), example.output) << example.command;
}

}  // namespace
}  // namespace tact::cli
