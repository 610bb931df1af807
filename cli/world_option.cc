#include "cli/world_option.h"

#include <algorithm>

#include "algebra/error.h"
#include "cli/text_pieces.h"

namespace tact::cli {

enumerators::ContactWorld ReadWorld(const EnumerateOptions& options, long long fewest_contacts) {
  const std::vector<std::string> names = enumerators::WorldNames();
  if (std::ranges::find(names, options.world) == names.end()) {
    throw InputError("--world: expected one of " + Join(names, ", ", [](const std::string& n) { return n; }) +
                     ", got " + options.world);
  }
  if (options.contacts < fewest_contacts) {
    throw InputError("--contacts: expected " + std::to_string(fewest_contacts) + " or more, got " +
                     std::to_string(options.contacts));
  }
  const size_t all = enumerators::NamedWorld(options.world, 0).contacts.size();
  return enumerators::NamedWorld(options.world, std::min(static_cast<size_t>(options.contacts), all));
}

}  // namespace tact::cli
