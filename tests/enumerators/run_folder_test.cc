#include "enumerators/run_folder.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <map>
#include <numeric>
#include <sstream>

#include "algebra/error.h"
#include "enumerators/whole_file.h"

namespace tact::enumerators {
namespace {

namespace fs = std::filesystem;

class RunFolder : public ::testing::Test {
 protected:
  RunFolder() {
    std::string name = (fs::temp_directory_path() / "tact_run_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    root_ = name;
  }
  ~RunFolder() override { fs::remove_all(root_); }

  // Squares of the units' numbers; counts what is computed.
  UnitRun Squares(size_t units = 10) {
    return {R"({"kind":"squares"})", units, [this](size_t unit) {
              ++computed_;
              return "[" + std::to_string(unit * unit) + "]";
            }};
  }
  RunOptions In(const std::string& folder, Shard shard = {}, size_t threads = 1) {
    return {root_ / folder, {}, shard, threads, {}};
  }
  // All texts in a row; empty if some are missing.
  std::string Run(const UnitRun& run, const RunOptions& options) {
    std::string texts;
    missing_ = RunUnits(run, options, [&](size_t, const std::string& text) { texts += text; });
    return texts;
  }
  static std::string Message(const std::function<void()>& call) {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "no InputError";
  }
  // Every file of a folder with its bytes.
  std::map<std::string, std::string> Files(const std::string& folder) {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(root_ / folder)) {
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), root_ / folder)] = ReadWhole(entry.path()).value();
    }
    return files;
  }

  fs::path root_;
  std::atomic<size_t> computed_ = 0;
  std::vector<size_t> missing_;
};

constexpr const char* kTenSquares = "[0][1][4][9][16][25][36][49][64][81]";

TEST_F(RunFolder, TextsComeInOrderOnAnyNumberOfThreadsInMemoryAndInAFolder) {
  for (const size_t threads : {1, 2, 7, 100}) {
    RunOptions memory;
    memory.threads = threads;
    EXPECT_EQ(Run(Squares(), memory), kTenSquares);
    EXPECT_EQ(Run(Squares(), In("threads" + std::to_string(threads), {}, threads)), kTenSquares);
    EXPECT_EQ(Files("threads" + std::to_string(threads)), Files("threads1"));
  }
  EXPECT_EQ(Run(Squares(0), In("none")), "");
  EXPECT_TRUE(missing_.empty());
}

TEST_F(RunFolder, NothingIsComputedTwice) {
  Run(Squares(), In("run"));
  EXPECT_EQ(computed_, 10U);
  fs::remove(root_ / "run/units/3.json");
  EXPECT_EQ(Run(Squares(), In("run")), kTenSquares);
  EXPECT_EQ(computed_, 11U);
}

TEST_F(RunFolder, ADamagedUnitIsComputedAgain) {
  Run(Squares(), In("run"));
  const auto whole = Files("run");
  const fs::path unit = root_ / "run/units/7.json";
  const std::string text = ReadWhole(unit).value();
  // Every way to cut it, and every byte changed.
  std::vector<std::string> damaged;
  for (size_t i = 0; i < text.size(); ++i) {
    damaged.push_back(text.substr(0, i));
    damaged.push_back(text);
    damaged.back()[i] = static_cast<char>(damaged.back()[i] ^ 1);
  }
  damaged.push_back(text + text);
  damaged.push_back(ReadWhole(root_ / "run/units/6.json").value());
  for (const std::string& bytes : damaged) {
    std::ofstream(unit, std::ios::binary) << bytes;
    computed_ = 0;
    ASSERT_EQ(Run(Squares(), In("run")), kTenSquares) << bytes;
    ASSERT_EQ(computed_, 1U) << bytes;
    ASSERT_EQ(Files("run"), whole);
  }
}

TEST_F(RunFolder, AnotherRunsFolderIsRefusedWithBothNamed) {
  Run(Squares(), In("run"));
  const auto before = Files("run");
  UnitRun cubes = Squares();
  cubes.description = R"({"kind":"cubes"})";
  const std::string message = Message([&] { Run(cubes, In("run")); });
  EXPECT_NE(message.find("squares"), std::string::npos) << message;
  EXPECT_NE(message.find("cubes"), std::string::npos) << message;
  EXPECT_NE(message.find("name another folder"), std::string::npos) << message;
  EXPECT_NE(Message([&] { Run(Squares(11), In("run")); }).find("name another folder"), std::string::npos);
  EXPECT_EQ(Files("run"), before);
}

TEST_F(RunFolder, AFolderOfSomethingElseIsLeftAlone) {
  fs::create_directory(root_ / "home");
  std::ofstream(root_ / "home/diary") << "mine";
  EXPECT_NE(Message([&] { Run(Squares(), In("home")); }).find("diary"), std::string::npos);
  EXPECT_EQ(Files("home").size(), 1U);
  EXPECT_NE(Message([&] { Run(Squares(), In("home/diary")); }).find("home/diary"), std::string::npos);
  EXPECT_NE(Message([&] { Run(Squares(), In("home/diary/below")); }).find("home/diary/below"),
            std::string::npos);
}

TEST_F(RunFolder, ShardsInOneFolderMakeTheSingleRun) {
  Run(Squares(), In("single"));
  EXPECT_EQ(Run(Squares(), In("run", {3, 3})), "");
  EXPECT_EQ(missing_, (std::vector<size_t>{0, 1, 3, 4, 6, 7, 9}));
  EXPECT_EQ(ShardsOf(missing_, 3), (std::vector<size_t>{1, 2}));
  EXPECT_EQ(Run(Squares(), In("run", {1, 3})), "");
  EXPECT_EQ(ShardsOf(missing_, 3), (std::vector<size_t>{2}));
  EXPECT_EQ(Run(Squares(), In("run", {2, 3})), kTenSquares);
  EXPECT_EQ(Files("run"), Files("single"));
  EXPECT_EQ(computed_, 20U);
  EXPECT_EQ(Run(Squares(2), In("few", {5, 9})), "");  // a shard without units
  EXPECT_EQ(missing_.size(), 2U);
}

TEST_F(RunFolder, UnitsOfOtherFoldersAreTakenOver) {
  Run(Squares(), In("single"));
  Run(Squares(), In("a", {1, 2}));
  Run(Squares(), In("b", {2, 2}));
  std::ofstream(root_ / "b/units/1.json") << "damaged";
  computed_ = 0;
  RunOptions options = In("all");
  options.sources = {root_ / "a", root_ / "b"};
  EXPECT_EQ(Run(Squares(), options), kTenSquares);
  EXPECT_EQ(computed_, 1U);
  EXPECT_EQ(Files("all"), Files("single"));
  options.folder.clear();
  EXPECT_EQ(Run(Squares(), options), kTenSquares);

  options.sources = {root_ / "nowhere"};
  EXPECT_NE(Message([&] { Run(Squares(), options); }).find("nowhere"), std::string::npos);
  UnitRun cubes = Squares();
  cubes.description = R"({"kind":"cubes"})";
  options.sources = {root_ / "a"};
  EXPECT_NE(Message([&] { Run(cubes, options); }).find("squares"), std::string::npos);
}

TEST_F(RunFolder, ProgressCountsTheUnitsOfTheShard) {
  Run(Squares(), In("run", {1, 2}));
  std::vector<std::pair<size_t, size_t>> told;
  RunOptions options = In("run", {2, 2}, 3);
  options.progress = [&](size_t done, size_t total) { told.emplace_back(done, total); };
  Run(Squares(), options);
  EXPECT_EQ(told, (std::vector<std::pair<size_t, size_t>>{{1, 5}, {2, 5}, {3, 5}, {4, 5}, {5, 5}}));
}

TEST_F(RunFolder, WhatAUnitThrowsComesOutAndWhatIsDoneStays) {
  UnitRun run = Squares();
  const auto square = run.compute;
  run.compute = [&](size_t unit) {
    if (unit == 6) throw BudgetError("unit 6 is too long");
    return square(unit);
  };
  EXPECT_THROW(Run(run, In("run", {}, 2)), BudgetError);
  const size_t before = computed_;
  EXPECT_GE(before, 5U);
  EXPECT_EQ(Run(Squares(), In("run")), kTenSquares);
  EXPECT_EQ(computed_, 10U);
}

TEST_F(RunFolder, NoSuchShardAndNoThreadAreRefused) {
  EXPECT_THROW(Run(Squares(), In("run", {0, 2})), PreconditionError);
  EXPECT_THROW(Run(Squares(), In("run", {3, 2})), PreconditionError);
  EXPECT_THROW(Run(Squares(), In("run", {}, 0)), PreconditionError);
  EXPECT_FALSE(fs::exists(root_ / "run"));
}

TEST_F(RunFolder, LeftoversOfAKilledRunAreRemoved) {
  Run(Squares(), In("run"));
  const auto whole = Files("run");
  std::ofstream(root_ / "run/.aside-abcdef") << "half";
  Run(Squares(), In("run"));
  EXPECT_EQ(Files("run"), whole);
}

// Exit status of a process that runs `call`: 0 if it returned, 7 after an InputError, 8 after anything else.
int InAnotherProcess(const std::function<void()>& call) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      call();
      _exit(0);
    } catch (const InputError&) {
      _exit(7);
    } catch (...) {
      _exit(8);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(RunFolder, AFullDiskIsAnErrorThatLeavesNothingHalfWritten) {
  UnitRun large = Squares();
  large.compute = [](size_t unit) { return "\"" + std::string(1000 * unit, 'x') + "\""; };
  Run(large, In("single"));
  const int status = InAnotherProcess([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{4096, 4096};  // bytes in a file
    setrlimit(RLIMIT_FSIZE, &limit);
    Run(large, In("run"));
  });
  EXPECT_EQ(status, 7);
  auto files = Files("run");
  EXPECT_EQ(files.size(), 6U);  // run.json and units 0 to 4; unit 5 has more than 5000 bytes
  for (const auto& [name, bytes] : files) EXPECT_EQ(bytes, Files("single").at(name));
  Run(large, In("run"));
  EXPECT_EQ(Files("run"), Files("single"));
}

TEST_F(RunFolder, ProcessesMayWorkInOneFolderAtOnce) {
  Run(Squares(200), In("single"));
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    const pid_t child = fork();
    if (child == 0) _exit(InAnotherProcess([&] { Run(Squares(200), In("run", {}, 2)); }));
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(Files("run"), Files("single"));
}

// Published values of FNV-1a, 64 bits.
TEST(RunDigest, IsFnv1a) {
  EXPECT_EQ(Digest(""), "cbf29ce484222325");
  EXPECT_EQ(Digest("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(Digest("foobar"), "85944171f73967e8");
}

}  // namespace
}  // namespace tact::enumerators
