// Hashes that states and manifests out in the world carry: no change of the program may change them.
#include <gtest/gtest.h>

#include <ostream>

#include "tests/world/scene/every_key.h"
#include "world/scene/scene_hash.h"
#include "world/world.h"

namespace prairie {
namespace {

struct Golden {
  const char* name;
  std::uint64_t scene_hash;
  std::uint64_t motion_hash;
};

void PrintTo(const Golden& golden, std::ostream* out) {
  *out << golden.name;
}

class GoldenExample : public ::testing::TestWithParam<Golden> {};

TEST_P(GoldenExample, KeepsItsHashes) {
  const World world(read_scene(std::filesystem::path(PRAIRIE_EXAMPLES) / GetParam().name, {}), {});
  EXPECT_EQ(world.scene_hash(), GetParam().scene_hash);
  EXPECT_EQ(world.motion_hash(), GetParam().motion_hash);
}

INSTANTIATE_TEST_SUITE_P(Examples, GoldenExample,
                         ::testing::Values(Golden{"meadow", 0xad8d27d936481509, 0xc0c564758adb969c},
                                           Golden{"windy", 0x89f928ea0909c72d, 0x91bb053846267186},
                                           Golden{"walkers", 0xb2016021ac3363b4, 0x27c5f12c0c401350},
                                           Golden{"frost", 0x85a5407443a0e68f, 0x5072cc016bb4cf69}),
                         [](const auto& golden) { return std::string(golden.param.name); });

void expect_hashes(const char* text, std::uint64_t scene_hash, std::uint64_t motion_hash) {
  const Scene scene = parse_scene(text, "folder", {});
  EXPECT_EQ(prairie::scene_hash(scene, testing::kEveryFile), scene_hash);
  EXPECT_EQ(prairie::motion_hash(scene, testing::kEveryFile), motion_hash);
}

TEST(GoldenScene, OfEveryKeyKeepsItsHashes) {
  expect_hashes(testing::kEveryKeyScene, 0x719a2f96ef37b03c, 0xe133a404e5f35f0d);
}

TEST(GoldenScene, OfKeysThatExcludeOthersKeepsItsHashes) {
  expect_hashes(testing::kExcludingKeysScene, 0x6616dddffad88c94, 0x6616dddffad88c94);
}

}  // namespace
}  // namespace prairie
