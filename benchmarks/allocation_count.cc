#include "benchmarks/allocation_count.h"

#include <atomic>
#include <cerrno>

// glibc's own entry points, and the documented way to replace malloc: define all of it in the program.
extern "C" {
void* __libc_malloc(size_t size);
void* __libc_calloc(size_t count, size_t size);
void* __libc_realloc(void* memory, size_t size);
void* __libc_memalign(size_t alignment, size_t size);
void __libc_free(void* memory);
}

namespace tact::benchmarks {
namespace {
std::atomic<size_t> count{0};
}  // namespace

size_t AllocationCount() { return count.load(std::memory_order_relaxed); }

}  // namespace tact::benchmarks

namespace {
void Count() { tact::benchmarks::count.fetch_add(1, std::memory_order_relaxed); }
}  // namespace

extern "C" {
void* malloc(size_t size) { return Count(), __libc_malloc(size); }
void* calloc(size_t n, size_t size) { return Count(), __libc_calloc(n, size); }
void* realloc(void* memory, size_t size) { return Count(), __libc_realloc(memory, size); }
void* memalign(size_t alignment, size_t size) { return Count(), __libc_memalign(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return Count(), __libc_memalign(alignment, size); }
int posix_memalign(void** memory, size_t alignment, size_t size) {
  Count();
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) { __libc_free(memory); }
}
