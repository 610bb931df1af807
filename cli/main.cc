// Reads the arguments, runs a command, and is the one place that catches.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <iostream>
#include <new>

#include "algebra/error.h"
#include "cli/commands.h"

namespace tact::cli {
namespace {

struct Command {
  const char* name;
  const char* summary;
  const char* details;  // below the options of --help
  ExitStatus (*run)(const FileOptions&);
};

constexpr const char* kRelationHelp =
    "FILE holds a contact relation in JSON, or many, one a line; - is standard input.\n"
    "A contact is a point and its planes, each a normal to the legal side:\n"
    "  {\"contacts\":[{\"point\":[0,0,0],\"planes\":[[0,0,1]]},{\"point\":[2,0,0],\"planes\":[[0,0,1]]}]}\n"
    "Numbers are exact; strings such as \"1/3\" are numbers too.\n";

const Command kCommands[] = {
    {"dof", "Motion DOFs of contact relations", "Example: tact dof edge_on_face.json --json", RunDof},
};

std::string CommandNames() {
  std::string names;
  for (const Command& command : kCommands) names += (names.empty() ? "" : ", ") + std::string(command.name);
  return names;
}

bool IsCommand(std::string_view word) {
  return std::any_of(std::begin(kCommands), std::end(kCommands), [&](const Command& c) { return c.name == word; });
}

int ReportUsage(const std::string& message) {
  std::cerr << "tact: " << message << "; tact --help says more\n";
  return kBadInput;
}

int Run(int argc, char** argv) {
  CLI::App app(
      "tact: exact contact kinematics\nExit status: 0 answered, 1 undecided, 2 bad input, 3 a bug of tact",
      "tact");
  app.set_version_flag("--version", "tact " TACT_VERSION);
  FileOptions options;
  ExitStatus (*run)(const FileOptions&) = nullptr;
  for (const Command& command : kCommands) {
    CLI::App* parser = app.add_subcommand(command.name, command.summary);
    parser->footer(std::string(kRelationHelp) + command.details);
    parser->add_option("FILE", options.file, "contact relations, or - for standard input")->required();
    parser->add_flag("--json", options.json, "answer in JSON, a line each");
    parser->callback([&run, &command] { run = command.run; });
  }
  if (argc > 1 && argv[1][0] != '-' && !IsCommand(argv[1])) {
    return ReportUsage("expected a command, one of " + CommandNames() + ", got " + argv[1]);
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return ReportUsage(error.what());
  }
  if (run == nullptr) return ReportUsage("expected a command, one of " + CommandNames() + ", got none");
  return run(options);
}

}  // namespace
}  // namespace tact::cli

int main(int argc, char** argv) {
  using namespace tact;
  std::ios::sync_with_stdio(false);
  try {
    return cli::Run(argc, argv);
  } catch (const InputError& error) {
    std::cerr << "tact: " << error.what() << "\n";
    return cli::kBadInput;
  } catch (const std::bad_alloc&) {
    std::cerr << "tact: expected to hold the input in memory, got no more of it\n";
    return cli::kBadInput;
  } catch (const std::exception& error) {
    std::cerr << "tact: a bug of tact, please report it with the input: " << error.what() << "\n";
    return cli::kOurBug;
  }
}
