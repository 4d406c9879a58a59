#include "app/commands/kept_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdlib>
#include <cstring>
#include <vector>

namespace prairie {
namespace {

/// Empty pages that the system has had to find for this process.
long page_faults() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_minflt;
}

/// Takes and frees ten megabytes in pieces of `bytes` again and again, as a frame does; page faults a frame.
long faults_a_frame(std::size_t bytes) {
  constexpr int kFrames = 20;
  long first = 0;
  for (int frame = 0; frame <= kFrames; ++frame) {
    if (frame == 1) first = page_faults();
    std::vector<void*> pieces;
    for (std::size_t taken = 0; taken < (std::size_t{10} << 20); taken += bytes) {
      pieces.push_back(std::malloc(bytes));
      std::memset(pieces.back(), 1, bytes);
    }
    for (void* piece : pieces) std::free(piece);
  }
  return (page_faults() - first) / kFrames;
}

TEST(KeptMemory, IsUsedAgain) {
#if !defined(__GLIBC__)
  GTEST_SKIP() << "another C library than glibc";
#elif defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers have an allocator of their own";
#else
  keep_freed_memory();
  for (const std::size_t bytes : {std::size_t{64} << 10, std::size_t{1} << 20, std::size_t{5} << 20})
    EXPECT_LT(faults_a_frame(bytes), 10) << bytes << " bytes a piece";
#endif
}

}  // namespace
}  // namespace prairie
