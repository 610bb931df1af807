/// @file
/// Long runs in numbered units: on several threads, in shards, kept in a folder so that nothing is computed twice.
/// Model   A run is a description and so many units, each with a text that only its number decides. Shard i of n has the
///         units whose number is i - 1 modulo n. The texts do not depend on threads, shards or interruptions.
/// Folder  run.json: the description. units/NUMBER.json: a unit's text with the digests of text and description; a file
///         that is not exactly that counts as missing. Files are whole or not there (whole_file.h), so a run may be killed at
///         any moment, and several processes may work in one folder. What a killed one leaves half-written is removed by
///         the next that has the folder to itself.
/// Errors  InputError: the folder holds another run or something else, or cannot be written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace tact::enumerators {

struct UnitRun {
  std::string description;  // a JSON value: all that the texts depend on
  size_t units = 0;
  std::function<std::string(size_t unit)> compute;  // a JSON value; called on several threads
};

struct Shard {
  size_t index = 1, count = 1;  // from 1
  bool Has(size_t unit) const { return unit % count == index - 1; }
};

struct RunOptions {
  std::filesystem::path folder;                // empty: texts are kept in memory
  std::vector<std::filesystem::path> sources;  // folders of the same run whose units are taken over
  Shard shard;
  size_t threads = 1;
  std::function<void(size_t done, size_t total)> progress;  // units of the shard; on one thread at a time
};

/// The units that are still missing, those of other shards; if there are none, take(unit, text) was called for each unit
/// in order. What `compute` throws comes out. PreconditionError: no such shard, no thread.
std::vector<size_t> RunUnits(const UnitRun& run, const RunOptions& options,
                             const std::function<void(size_t unit, const std::string& text)>& take);

/// The shards of so many that have missing units, increasing, from 1.
std::vector<size_t> ShardsOf(const std::vector<size_t>& units, size_t shards);

/// FNV-1a, 64 bits, in 16 hexadecimal digits: tells damage from content, not malice.
std::string Digest(std::string_view text);

}  // namespace tact::enumerators
