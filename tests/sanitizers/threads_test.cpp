// One meadow, read and planted from many threads at once. These are plain threads: oneTBB's, which the
// program uses, are not instrumented (nor is OpenImageIO's cache), and the thread sanitizer would take what
// is ordered inside them for races.
#include <gtest/gtest.h>

#include <thread>
#include <vector>

#include "generator/plant.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr int kThreads = 4;
constexpr int kTiles = 4;  // along each side

TEST(Threads, PlantTheSameMeadowAlike) {
  const Meadow meadow = rich_meadow(16.0);
  std::vector<std::vector<std::uint64_t>> hashes(kThreads);
  std::vector<std::thread> threads;
  for (std::vector<std::uint64_t>& own : hashes) {
    threads.emplace_back([&meadow, &own] {
      for (int j = 0; j < kTiles; ++j) {
        for (int i = 0; i < kTiles; ++i) {
          own.push_back(tile_hash(meadow, {i, j}));
          own.push_back(planted_count(meadow, {i, j}));
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (const std::vector<std::uint64_t>& own : hashes) EXPECT_EQ(own, hashes.front());
}

}  // namespace
}  // namespace prairie
