/// @file
/// The certificate checker: accepts a certificate or says why not (docs/certificates.md).
/// Exact   integers of any size, + * = < only.
/// Errors  none are thrown for bad certificates: a refusal is an answer.
/// Cost    about linear in the text, except for numbers of many digits.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace tact::check {

/// What became of one certificate.
struct Answer {
  bool accepted = false;
  std::string why;    // of a refusal: `relation.contacts[3].planes[0]: zero normal`
  std::string claim;  // the claim it names; empty if it could not be read
  /// Of an accepted census whose world was not counted again: why not.
  std::string not_recounted;
};

Answer CheckCertificate(std::string_view text);

struct Refusal {
  std::string file;
  std::string why;
};

struct Report {
  std::size_t accepted = 0;             // certificates
  std::vector<Refusal> refused;         // certificates, and what a ledger gets wrong about them
  std::vector<Refusal> not_recounted;   // accepted censuses whose world was not counted again
  std::vector<std::string> unreadable;  // `file: why`
};

/// Checks a certificate file, a folder of `.json` certificates, or a report folder: one with `certificates/`
/// or `ledger.json`, whose claims must then name their certificates rightly. Adds to report, in the order of
/// file names.
void CheckPath(const std::string& path, Report& report);

}  // namespace tact::check
