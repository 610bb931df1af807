#include "tests/cli/run_program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace tact::cli {
namespace {

std::string ReadText(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::filesystem::path NewFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "tact_cli_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  return name;
}

}  // namespace

// Files for the three streams: no pipe can fill up.
Answer RunTact(const std::vector<std::string>& arguments, const std::string& input) {
  const std::filesystem::path folder = NewFolder();
  const std::string in = folder / "in", out = folder / "out", err = folder / "err";
  std::ofstream(in, std::ios::binary) << input;
  std::vector<char*> argv{const_cast<char*>("tact")};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    dup2(open(in.c_str(), O_RDONLY), STDIN_FILENO);
    dup2(open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    dup2(open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    execv(TACT_PROGRAM, argv.data());
    _exit(127);
  }
  int status = 0;
  waitpid(child, &status, 0);
  Answer answer{WIFEXITED(status) ? WEXITSTATUS(status) : -1, ReadText(out), ReadText(err)};
  std::filesystem::remove_all(folder);
  return answer;
}

TemporaryFile::TemporaryFile(const std::string& name, const std::string& text)
    : folder_(NewFolder()), path_(std::filesystem::path(folder_) / name) {
  std::ofstream(path_, std::ios::binary) << text;
}

TemporaryFile::~TemporaryFile() { std::filesystem::remove_all(folder_); }

namespace {

TEST(Program, SaysItsVersionAndItsHelp) {
  EXPECT_EQ(RunTact({"--version"}).out, "tact 0.1.0\n");
  const Answer help = RunTact({"--help"});
  EXPECT_EQ(help.status, 0);
  EXPECT_NE(help.out.find("Subcommands"), std::string::npos);
  for (const char* command : {"dof", "modes"}) {
    EXPECT_NE(help.out.find(command), std::string::npos);
    const Answer details = RunTact({command, "--help"});
    EXPECT_EQ(details.status, 0);
    EXPECT_NE(details.out.find(std::string("Example: tact ") + command), std::string::npos) << details.out;
  }
}

TEST(Program, RefusesWhatIsNoCommandAndNamesThem) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"degrees"}, {}}) {
    const Answer answer = RunTact(arguments);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.out, "");
    EXPECT_NE(answer.err.find("expected a command, one of dof, modes"), std::string::npos) << answer.err;
  }
}

TEST(Program, RefusesWrongArguments) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"dof"}, {"dof", "a", "b"}, {"dof", "--jason", "a"}, {"--wrong"}}) {
    const Answer answer = RunTact(arguments);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(answer.err.substr(0, 6), "tact: ");
  }
}

TEST(Program, SaysWhyAFileCannotBeRead) {
  const Answer absent = RunTact({"dof", "no/such/file.json"});
  EXPECT_EQ(absent.status, 2);
  EXPECT_EQ(absent.err,
            "tact: no/such/file.json: expected a readable file, got: No such file or directory\n");
  const Answer folder = RunTact({"dof", "/"});
  EXPECT_EQ(folder.status, 2);
  EXPECT_EQ(folder.err, "tact: /: expected a file, got a folder\n");
}

}  // namespace
}  // namespace tact::cli
