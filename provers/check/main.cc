// tact-check: argument parsing and printing.
#include <cstdio>
#include <exception>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "provers/check/check.h"

namespace {

constexpr char kUsage[] = "usage: tact-check [--json] DIR|FILE...\n";
constexpr char kHelp[] =
    "\n"
    "Checks certificates (docs/certificates.md) on its own, in exact integers, and says why it refuses one.\n"
    "A FILE is one certificate. A DIR is a report folder, where the certificates in certificates/ and what "
    "ledger.json\n"
    "says of them are checked, or a folder of .json certificates.\n"
    "\n"
    "  --json   print {\"accepted\":N,\"refused\":[{\"file\":...,\"why\":...},...],\"not_recounted\":[the "
    "same]}\n"
    "  --help   print this\n"
    "\n"
    "Exit status: 0 all accepted, 1 something refused, 2 bad usage or an unreadable file, 3 an error of "
    "tact-check.\n"
    "\n"
    "example:\n"
    "  tact-check report/\n"
    "  tact-check --json report/certificates/edge_on_face.json\n";

void PrintJson(const tact::check::Report& report) {
  nlohmann::ordered_json out = {{"accepted", report.accepted}, {"refused", nlohmann::ordered_json::array()}};
  for (const auto& [file, why] : report.refused) out["refused"].push_back({{"file", file}, {"why", why}});
  out["not_recounted"] = nlohmann::ordered_json::array();
  for (const auto& [file, why] : report.not_recounted)
    out["not_recounted"].push_back({{"file", file}, {"why", why}});
  std::puts(out.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace).c_str());
}

void PrintText(const tact::check::Report& report) {
  for (const auto& [file, why] : report.refused) std::printf("%s: refused: %s\n", file.c_str(), why.c_str());
  for (const auto& [file, why] : report.not_recounted)
    std::printf("%s: accepted, but its world was not counted again: %s\n", file.c_str(), why.c_str());
  std::printf("%zu certificates accepted, %zu refused\n", report.accepted, report.refused.size());
}

int Run(const std::vector<std::string>& arguments) {
  bool json = false;
  std::vector<std::string> paths;
  for (const std::string& argument : arguments) {
    if (argument == "--help" || argument == "-h") {
      std::printf("%s%s", kUsage, kHelp);
      return 0;
    }
    if (argument == "--json") {
      json = true;
    } else if (argument.starts_with("-")) {
      std::fprintf(stderr, "tact-check: there is no option %s\n%s", argument.c_str(), kUsage);
      return 2;
    } else {
      paths.push_back(argument);
    }
  }
  if (paths.empty()) {
    std::fprintf(stderr, "tact-check: name a folder or a file\n%s", kUsage);
    return 2;
  }
  tact::check::Report report;
  for (const std::string& path : paths) tact::check::CheckPath(path, report);
  json ? PrintJson(report) : PrintText(report);
  for (const std::string& line : report.unreadable) std::fprintf(stderr, "tact-check: %s\n", line.c_str());
  if (!report.unreadable.empty()) return 2;
  return report.refused.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return Run({argv + 1, argv + argc});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "tact-check: %s\n", error.what());
    return 3;
  }
}
