#include "world/world.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "generator/plant.h"
#include "tests/world/scene_texts.h"
#include "world/motion.h"

namespace prairie {
namespace {

using testing::open_scene;
using testing::write_raster;

float rolling(int column, int row) {
  return 10.0f + 0.1f * static_cast<float>(column + row);
}
float column_share(int column, int) {
  return 0.1f * static_cast<float>(column);
}

constexpr const char* kMappedScene = R"(version = 1
[height]
file = "height.tif"
[[species]]
name = "a"
density = { file = "density.tif" }
)";

TEST(World, LevelGroundHasTheSizeItIsGiven) {
  const World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(40.0, 20.0));
  EXPECT_TRUE(world.meadow().ground.is_uniform());
  EXPECT_FALSE(world.geo_reference());
  EXPECT_TRUE(world.maps().empty());
  EXPECT_EQ(world.meadow().species[0].density_per_m2.sample({1.0, 1.0}), 1000.0f);
}

TEST(World, ExtentIsTheHeightMaps) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 11, 21, 2.0, std::nullopt, rolling);
  write_raster(folder / "density.tif", 11, 21, 2.0, std::nullopt, column_share);
  const World world = open_scene(folder.path(), kMappedScene);
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(20.0, 40.0));
  EXPECT_FLOAT_EQ(world.meadow().ground.height_m({4.0, 6.0}), 10.5f);
  EXPECT_TRUE(world.warnings().empty()) << world.warnings().front().text;
}

TEST(World, ExtentIsTheFirstDensityMapsWithoutAHeightMap) {
  const TemporaryFolder folder;
  write_raster(folder / "density.tif", 11, 5, 2.0, glm::dvec2(500.0, 600.0), column_share);
  const World world = open_scene(
      folder.path(),
      "version = 1\n[[species]]\nname = \"a\"\ndensity = { file = \"density.tif\", max_per_m2 = 10 }\n");
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(20.0, 8.0));
  ASSERT_TRUE(world.geo_reference());
  EXPECT_EQ(world.geo_reference()->west_m, 500.0);
  EXPECT_FLOAT_EQ(world.meadow().species[0].density_per_m2.sample({4.0, 4.0}), 2.0f);
}

TEST(World, PlacesMapsByTheirGeoReference) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 101, 101, 1.0, glm::dvec2(702'000.5, 4'333'000.5), rolling);
  // Another resolution and another origin: 10 m east and 20 m south of the height map's corner.
  write_raster(folder / "density.tif", 41, 41, 2.0, glm::dvec2(702'010.5, 4'332'980.5),
               [](int column, int row) { return column == 5 && row == 15 ? 1.0f : 0.0f; });
  const World world = open_scene(folder.path(), kMappedScene);
  const NodeGrid& density = world.meadow().species[0].density_per_m2;
  EXPECT_EQ(density.frame().origin_m, glm::dvec2(10.0, -20.0));
  EXPECT_FLOAT_EQ(density.sample({20.0, 10.0}), 1000.0f);
  EXPECT_FLOAT_EQ(density.sample({21.0, 10.0}), 500.0f);
  EXPECT_TRUE(std::isnan(density.sample({5.0, 10.0}))) << "west of the map";
  EXPECT_EQ(world.geo_reference()->south_m, 4'333'000.5);
  ASSERT_FALSE(world.warnings().empty());
  EXPECT_NE(world.warnings().back().text.find("covers only"), std::string::npos)
      << world.warnings().back().text;
}

TEST(World, PlacesMapsThatStayOnDiskToo) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 11, 11, 10.0, glm::dvec2(0.0, 0.0), rolling);
  write_raster(folder / "density.tif", 601, 601, 0.2, glm::dvec2(-10.0, -10.0),
               [](int column, int) { return static_cast<float>(column) / 600.0f; });
  testing::write_text(folder / kSceneFileName, kMappedScene);
  WorldOptions options;
  options.memory_budget_bytes = 1 << 20;
  const World world(read_scene(folder.path(), {}), options);
  ASSERT_FALSE(world.maps().at(1).in_memory);
  EXPECT_EQ(world.maps().at(1).memory_bytes, 0u);
  EXPECT_NEAR(world.meadow().species[0].density_per_m2.sample({50.0, 50.0}), 500.0f, 0.01f);
}

TEST(World, RefusesAMapThatMissesTheGround) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 11, 11, 1.0, glm::dvec2(0.0, 0.0), rolling);
  write_raster(folder / "density.tif", 11, 11, 1.0, glm::dvec2(50.0, 0.0), column_share);
  try {
    open_scene(folder.path(), kMappedScene);
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, (folder / "density.tif").string());
    EXPECT_EQ(fault.field, "species.0.density.file");
    EXPECT_EQ(fault.found, "a map from (50.0, 0.0) to (60.0, 10.0) m");
    EXPECT_NE(fault.expected.find("reaches the ground"), std::string::npos);
  }
}

TEST(World, CoarserMapsOfTheSameAreaCoverIt) {
  const TemporaryFolder folder;
  // Pixels of 1 m and of 5 m over the same 100 m: their outermost centres differ by 2 m.
  write_raster(folder / "height.tif", 100, 100, 1.0, glm::dvec2(0.5, 0.5), rolling);
  write_raster(folder / "density.tif", 20, 20, 5.0, glm::dvec2(2.5, 2.5), column_share);
  const World world = open_scene(folder.path(), kMappedScene);
  for (const Warning& warning : world.warnings())
    EXPECT_EQ(warning.text.find("covers"), std::string::npos) << warning.text;
}

TEST(World, RepeatsEndlessly) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 10, 10, 2.0, std::nullopt, rolling);
  write_raster(folder / "density.tif", 10, 10, 2.0, std::nullopt, column_share);
  std::string text = kMappedScene;
  text.replace(text.find("[[species]]"), 0, "repeat = true\n");
  const World world = open_scene(folder.path(), text);
  EXPECT_TRUE(world.meadow().repeats);
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(20.0, 20.0));
  const NodeGrid& density = world.meadow().species[0].density_per_m2;
  EXPECT_EQ(density.sample({3.0, 3.0}), density.sample({3.0 + 60.0, 3.0 - 40.0}));
  EXPECT_FLOAT_EQ(world.meadow().ground.height_m({2.0, 2.0}), world.meadow().ground.height_m({42.0, -18.0}));
}

TEST(World, NamesTheHeightMapThatHoldsNothing) {
  const TemporaryFolder folder;
  write_raster(folder / "density.tif", 11, 11, 1.0, std::nullopt, column_share);
  write_raster(folder / "height.tif", 11, 11, 1.0, std::nullopt, [](int, int) { return NAN; });
  try {
    open_scene(folder.path(), kMappedScene);
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, (folder / "height.tif").string());
    EXPECT_EQ(fault.field, "height.file");
  }
}

TEST(World, NamesAMissingMap) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 11, 11, 1.0, std::nullopt, rolling);
  try {
    open_scene(folder.path(), kMappedScene);
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, (folder / "density.tif").string());
    EXPECT_EQ(fault.field, "species.0.density.file");
  }
}

TEST(World, RefusesASingleRowOfHeights) {
  const TemporaryFolder folder;
  write_raster(folder / "height.tif", 11, 1, 1.0, std::nullopt, rolling);
  write_raster(folder / "density.tif", 11, 11, 1.0, std::nullopt, column_share);
  EXPECT_THROW(open_scene(folder.path(), kMappedScene), BadInput);
}

TEST(World, GivesASceneWithoutACameraADefaultOne) {
  const World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  ASSERT_EQ(world.scene().cameras.size(), 1u);
  EXPECT_EQ(world.scene().cameras[0].name, "default");
}

TEST(World, StepsTime) {
  World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  EXPECT_EQ(world.time_s(), 0.0);
  world.step(0.25);
  world.step(0.25);
  EXPECT_EQ(world.time_s(), 0.5);
}

DrivenMover stone_at(const World& world, glm::dvec2 contact_m) {
  DrivenMover stone;
  stone.place = stone_place(world.meadow().ground, stone.radius_m, contact_m, {1.0, 0.0}, 0.0);
  stone.before = stone.place;
  return stone;
}

TEST(World, WhatIsDrivenTreadsItsWay) {
  World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  world.driven().push_back(stone_at(world, {5.0, 5.0}));
  world.step(1.0 / 30.0);
  world.driven()[0].place = stone_at(world, {6.0, 5.0}).place;
  world.step(1.0 / 30.0);
  EXPECT_EQ(world.driven()[0].before.contact_m, glm::dvec2(6.0, 5.0));
  EXPECT_GT(world.motion().treading().sample({5.5, 5.0}).tilt_rad, 0.5f);
  EXPECT_EQ(world.motion().treading().sample({9.0, 5.0}).tilt_rad, 0.0f);
}

TEST(World, TheEyesWakeStirsCalmAir) {
  World world(parse_scene(testing::kPlainScene, "folder", {}), {});
  Motion& motion = world.motion();
  motion.watch({5.0, 5.0});
  motion.wake(true);
  world.step(1.0 / 30.0);
  EXPECT_TRUE(motion.is_still()) << "nothing has moved";
  for (int n = 1; n <= 10; ++n) {
    motion.watch({5.0 + 0.2 * n, 5.0});
    world.step(1.0 / 30.0);
  }
  ASSERT_TRUE(motion.sway());
  EXPECT_GT(motion.sway()->mean_tip({8.0, 5.0}).x, 0.001f);
  motion.restore(world.meadow(), World(parse_scene(testing::kPlainScene, "folder", {}), {}).motion().state());
  EXPECT_FALSE(motion.wind().wake) << "earlier than what was stirred up";
}

}  // namespace
}  // namespace prairie
