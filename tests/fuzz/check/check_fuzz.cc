// Any text is answered: accepted, or refused with a reason that can be printed; the same without its outer
// blanks.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "provers/check/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const tact::check::Answer answer = tact::check::CheckCertificate(text);
  if (answer.accepted != answer.why.empty()) std::abort();
  for (char c : answer.why) {
    if (c < ' ' || c > '~') std::abort();
  }
  const std::string padded = " \n" + std::string(text) + "\t ";
  if (!text.starts_with('\xef') && tact::check::CheckCertificate(padded).accepted != answer.accepted)
    std::abort();
  return 0;
}
