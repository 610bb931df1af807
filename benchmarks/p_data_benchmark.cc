/// @file
/// All codes of a sphere: streamed, counted by every key, counted by transfer.
/// Model   Rates are codes a second on one thread, medians over rounds; the peer of the stream is the walk that makes a PData of each
///         code. Counts are compared between the methods and with OEIS A373325.
/// Exit    0; 1 if a count differs, or with --require RATE if the stream is slower.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "enumerators/code_counts.h"
#include "enumerators/code_transfer.h"
#include "enumerators/planar_p_data.h"

namespace tact::benchmarks {
namespace {

using enumerators::Code;
using Clock = std::chrono::steady_clock;

constexpr uint64_t kPublished[] = {1,     2,      10,      66,       498,       4072,
                                   35144, 315352, 2914074, 27553880, 265387528, 2595131328};

struct Timed {
  uint64_t codes = 0;
  double seconds = 0;
};

template <typename Count>
Timed MedianOf(int rounds, const Count& count) {
  std::vector<double> seconds;
  Timed timed;
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    timed.codes = count();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  std::sort(seconds.begin(), seconds.end());
  timed.seconds = seconds[seconds.size() / 2];
  return timed;
}

bool Print(const char* what, int crossings, const Timed& timed) {
  const bool right = timed.codes == kPublished[crossings];
  std::printf("%-44s n = %2d  %12llu codes  %8.3f s  %9.3g a second%s\n", what, crossings,
              static_cast<unsigned long long>(timed.codes), timed.seconds,
              static_cast<double>(timed.codes) / timed.seconds, right ? "" : "  WRONG");
  return right;
}

int Run(double require) {
  bool good = true;
  // The visitor reads a byte of each row, so that every code is there to be read.
  uint64_t sum = 0;
  const auto stream = [&](int crossings) {
    uint64_t codes = 0;
    enumerators::ForEachCode(crossings, [&](const Code& code) {
      ++codes;
      sum += static_cast<uint64_t>(code.sigma[1] + code.turn[static_cast<size_t>(code.columns)]);
    });
    return codes;
  };
  const Timed streamed = MedianOf(5, [&] { return stream(9); });
  good &= Print("streamed", 9, streamed);
  const Timed as_p_data = MedianOf(3, [&] {
    uint64_t codes = 0;
    enumerators::ForEachCode(8, [&](const Code& code) {
      sum += static_cast<uint64_t>(WithHeights(code, 0).sigma(1));
      ++codes;
    });
    return codes;
  });
  good &= Print("streamed, each made a PData", 8, as_p_data);
  const Timed keys = MedianOf(3, [&] { return enumerators::CountCodes(8).back().codes; });
  good &= Print("by every key (aim 10 s)", 8, keys);
  good &= Print("streamed (aim 15 s)", 10, MedianOf(1, [&] { return stream(10); }));
  for (const int crossings : {10, 11}) {
    good &= Print("by transfer", crossings,
                  MedianOf(3, [&] { return enumerators::CountCodesByTransfer(crossings).back(); }));
  }
  const double rate = static_cast<double>(streamed.codes) / streamed.seconds;
  std::printf("making a PData of each takes %.1f times as long as the stream; every key %.1f times (%llu)\n",
              as_p_data.seconds / static_cast<double>(as_p_data.codes) * rate,
              keys.seconds / static_cast<double>(keys.codes) * rate,
              static_cast<unsigned long long>(sum % 10));
  return good && rate >= require ? 0 : 1;
}

}  // namespace
}  // namespace tact::benchmarks

int main(int argc, char** argv) {
  const bool require = argc == 3 && std::strcmp(argv[1], "--require") == 0;
  return tact::benchmarks::Run(require ? std::strtod(argv[2], nullptr) : 0);
}
