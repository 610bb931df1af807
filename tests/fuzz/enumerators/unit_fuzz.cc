// What a unit of a run says is read back exactly as it was written, or refused with a sentence.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "algebra/error.h"
#include "enumerators/dof_counts_text.h"
#include "enumerators/dof_step_census.h"

namespace {

// Reads and writes again; a text that is read must come out the same.
template <typename Read>
void RoundTrip(const std::string& text, Read read) {
  try {
    if (ToText(read(text)) != text) std::abort();
  } catch (const tact::InputError& error) {
    if (std::string(error.what()).empty()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  namespace enumerators = tact::enumerators;
  RoundTrip(text, [](const std::string& t) { return enumerators::ParseDofCounts(t); });
  RoundTrip(text, [](const std::string& t) { return enumerators::ParseDofSteps(t); });
  return 0;
}
