#include "world/example_meadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "app/scenes/new_scene.h"
#include "maps/map_file.h"
#include "tests/world/scene_texts.h"
#include "world/camera_placement.h"
#include "world/world.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

const fs::path kCommitted = fs::path(PRAIRIE_SOURCES) / "examples/meadow";

double mean_per_m2(const GreyMap& map) {
  const double sum = std::accumulate(map.values.begin(), map.values.end(), 0.0);
  return sum / 255.0 * map.max / static_cast<double>(map.values.size());
}

TEST(ExampleMeadow, IsAMeadowForEverySeed) {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 99u}) {
    const ExampleMeadow meadow = make_example_meadow(seed);
    const auto [lowest, highest] =
        std::minmax_element(meadow.ground_m.values().begin(), meadow.ground_m.values().end());
    EXPECT_GT(*highest - *lowest, 5.0f) << seed;
    EXPECT_LT(*highest - *lowest, 16.0f) << seed;
    EXPECT_GT(mean_per_m2(meadow.fescue_per_m2), 1000.0) << seed;
    EXPECT_LT(mean_per_m2(meadow.fescue_per_m2), 1500.0) << seed;
    EXPECT_GT(mean_per_m2(meadow.oatgrass_per_m2), 30.0) << seed;
    EXPECT_LT(mean_per_m2(meadow.oatgrass_per_m2), 200.0) << seed;
    const auto& values = meadow.fescue_per_m2.values;
    EXPECT_EQ(*std::min_element(values.begin(), values.end()), 0) << "the path, seed " << seed;
  }
}

TEST(ExampleMeadow, SeedsDiffer) {
  EXPECT_NE(make_example_meadow(1).fescue_per_m2.values, make_example_meadow(2).fescue_per_m2.values);
}

TEST(ExampleMeadow, DefaultCamerasStandOnPlantedGround) {
  const TemporaryFolder folder;
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u, 5u, 99u}) {
    NewSceneRequest request;
    request.folder = folder / std::to_string(seed);
    request.seed = seed;
    new_scene(request);
    const World world(read_scene(request.folder, {}), {});
    for (const CameraSpec& camera : world.scene().cameras) {
      if (camera.name == "top") continue;
      EXPECT_TRUE(is_planted(world.meadow(), camera.position_m)) << camera.name << ", seed " << seed;
      const NodeGrid& fescue = world.meadow().species[0].density_per_m2;
      EXPECT_GT(fescue.sample(camera.position_m), 300.0f) << camera.name << ", seed " << seed;
    }
    EXPECT_TRUE(world.warnings().empty()) << world.warnings().front().text;
  }
}

std::vector<float> heights_m(const fs::path& file) {
  MapSpec spec;
  spec.file = file;
  const NodeGrid grid = read_map(spec, MapMeaning::kHeight, std::uint64_t{1} << 24).grid;
  return {grid.values().begin(), grid.values().end()};
}

TEST(ExampleMeadow, IsTheCommittedOne) {
  const TemporaryFolder folder;
  NewSceneRequest request;
  request.folder = folder / "meadow";
  new_scene(request);
  std::vector<std::string> names;
  std::uintmax_t bytes = 0;
  for (const auto& entry : fs::directory_iterator(request.folder)) {
    const std::string name = entry.path().filename().string();
    names.push_back(name);
    bytes += entry.file_size();
    // Libraries pack the same heights in their own ways.
    if (name == "ground.tif") {
      EXPECT_EQ(heights_m(entry.path()), heights_m(kCommitted / name));
    } else {
      EXPECT_EQ(testing::read_bytes(entry.path()), testing::read_bytes(kCommitted / name)) << name;
    }
  }
  EXPECT_EQ(names.size(), 5u);
  EXPECT_LT(bytes, 400'000u);
}

TEST(ExampleMeadow, IsLargeEnoughAndHasTwoSpecies) {
  const World world(read_scene(kCommitted, {}), {});
  EXPECT_GE(world.meadow().extent_m.x, 128.0);
  EXPECT_GE(world.meadow().extent_m.y, 128.0);
  EXPECT_EQ(world.meadow().species.size(), 2u);
  EXPECT_EQ(world.scene().cameras.front().name, "default");
}

}  // namespace
}  // namespace prairie
