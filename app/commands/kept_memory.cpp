#include "app/commands/kept_memory.h"

#include <cstdlib>  // which tells whether the C library is glibc

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace prairie {

void keep_freed_memory() {
#if defined(__GLIBC__)
  // glibc allows no more for the first. Larger pieces still come from the system and go back to it.
  constexpr int kLargestKept = 32 << 20;
  constexpr int kMostKept = 512 << 20;
  mallopt(M_MMAP_THRESHOLD, kLargestKept);
  mallopt(M_TRIM_THRESHOLD, kMostKept);
#endif
}

}  // namespace prairie
