// See heap.h.
#include <cstdlib>

#include "filters/platform/heap.h"

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <climits>
#include <cstdint>
#endif

namespace boxprobe {

#ifdef __GLIBC__
namespace {

/// Is there a limit on addresses? They are then for what is needed.
bool limited(decltype(RLIMIT_AS) resource) {
  rlimit limit = {};
  return getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace
#endif

void useLargePages() {
#ifdef __GLIBC__
  if (limited(RLIMIT_AS) || limited(RLIMIT_DATA)) return;
  // Addresses, not memory: pages are there once they are written to. Two megabytes are a large page of x86 and ARM.
  constexpr int kReserved = 256 << 20, kLargePage = 2 << 20;
  mallopt(M_ARENA_MAX, 1);  // threads' own would grow in small pages
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, INT_MAX);
  mallopt(M_TOP_PAD, kReserved);
  const auto before = reinterpret_cast<std::uintptr_t>(sbrk(0));
  void* volatile grows = std::malloc(kLargePage);  // volatile, or compilers leave both calls out
  std::free(grows);
  const auto after = reinterpret_cast<std::uintptr_t>(sbrk(0));
  mallopt(M_TOP_PAD, kLargePage);
  const std::uintptr_t begin = (before + kLargePage - 1) / kLargePage * kLargePage;
  if (after > begin) madvise(reinterpret_cast<void*>(begin), after - begin, MADV_HUGEPAGE);
#endif
}

}  // namespace boxprobe
