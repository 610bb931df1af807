/// @file
/// The contact world that an enumeration's options name.
/// Errors  InputError: no such world, a number of contacts that makes no sense.
#pragma once

#include "cli/commands.h"
#include "enumerators/contact_world.h"

namespace tact::cli {

/// The named world with relations of at most so many contacts, all of its contacts at most.
enumerators::ContactWorld ReadWorld(const EnumerateOptions& options, long long fewest_contacts);

}  // namespace tact::cli
