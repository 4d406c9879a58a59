#include "world/scene/scene_hash.h"

#include <gtest/gtest.h>

#include "tests/world/scene_texts.h"

namespace prairie {
namespace {

TEST(SceneHash, KnowsMapsByContentNotByName) {
  const TemporaryFolder folder;
  const auto open = [&](const char* name, const char* file, float somewhere) {
    std::filesystem::create_directories(folder / name);
    testing::write_raster(folder / name / file, 9, 9, 1.0, std::nullopt,
                          [&](int column, int row) { return column == 4 && row == 4 ? somewhere : 0.5f; });
    const std::string text =
        "version = 1\n[[species]]\nname = \"a\"\ndensity = { file = \"" + std::string(file) + "\" }\n";
    return testing::open_scene(folder / name, text).scene_hash();
  };
  const std::uint64_t hash = open("here", "a.tif", 0.25f);
  EXPECT_EQ(hash, open("there", "a.tif", 0.25f));
  EXPECT_EQ(hash, open("renamed", "b.tif", 0.25f));
  EXPECT_NE(hash, open("changed", "a.tif", 0.26f));
}

TEST(SceneHash, KnowsTheSeedInUse) {
  const Scene scene = parse_scene(testing::kPlainScene, "folder", {});
  WorldOptions other;
  other.seed = 5;
  EXPECT_NE(World(scene, {}).scene_hash(), World(scene, other).scene_hash());
  EXPECT_EQ(World(scene, other).meadow().seed, 5u);
}

}  // namespace
}  // namespace prairie
