/// @file
/// How often the program took memory from the heap.
/// Model   malloc and its kin are replaced for the whole program: operator new, GMP and every library end
///         there.
#pragma once

#include <cstddef>

namespace tact::benchmarks {

/// Calls of malloc, calloc, realloc and the aligned ones so far.
size_t AllocationCount();

}  // namespace tact::benchmarks
