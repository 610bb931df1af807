/// @file
/// The commands of `tact`, one a file; main.cc reads their arguments and catches their errors.
/// Errors  InputError for bad input and for output that cannot be written.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tact::cli {

/// Exit statuses.
enum ExitStatus : int { kAnswered = 0, kUndecided = 1, kBadInput = 2, kOurBug = 3 };

struct FileOptions {
  std::string file;   // "-" is standard input
  bool json = false;  // one JSON object a line
};

struct ContactsOptions {
  std::string moving, fixed;    // mesh files
  std::string pose;             // of the moving model in the fixed one's frame, in JSON or a file of it
  std::string tolerance = "0";  // millimetres
  std::string unit;             // of both models and of the pose
  std::string svg;              // a file for a drawing; empty: none
  bool json = false;
};

struct VerifyOptions {
  bool quick = false, full = false;
  std::vector<std::string> only;  // globs of claim ids; none: every claim
  std::string directory = "report";
};

struct EnumerateOptions {
  std::string world = "corner";  // enumerators::WorldNames
  long long contacts = 7;        // in a relation, at most
  bool json = false, csv = false;
  std::string directory;             // of the run and its results; empty: nothing is kept
  std::optional<long long> threads;  // none: as many as there are cores
  std::string shard = "1/1";         // which part of the run: i/n
  std::vector<std::string> from;     // directories of the same run whose units are taken over
  bool yes = false;                  // however long it takes
};

/// Motion DOFs of each contact relation of a file.
ExitStatus RunDof(const FileOptions& options);
/// Contact modes of each contact relation of a file.
ExitStatus RunModes(const FileOptions& options);
/// The contact relation of two models in a pose.
ExitStatus RunContacts(const ContactsOptions& options);
/// Contact relations, transitions, sub-skills and critical transitions of a demonstration.
ExitStatus RunRecognize(const FileOptions& options);
/// The ledger of claims on trial; writes the report.
ExitStatus RunVerify(const VerifyOptions& options);
/// The exact list of DOF classes, with witnesses from a finite world.
ExitStatus RunEnumerateDofClasses(const EnumerateOptions& options);
/// Steps between contact relations, and the DOF-transitions that solids show.
ExitStatus RunEnumerateDofTransitions(const EnumerateOptions& options);

}  // namespace tact::cli
