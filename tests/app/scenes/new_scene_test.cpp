#include "app/scenes/new_scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "app/terminal/usage_error.h"
#include "maps/geotiff_output.h"
#include "pictures/picture_encoding.h"
#include "tests/world/scene_texts.h"
#include "world/camera_placement.h"
#include "world/world.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;
using testing::write_raster;

std::map<std::string, std::vector<std::byte>> contents(const fs::path& folder) {
  std::map<std::string, std::vector<std::byte>> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    files[entry.path().filename().string()] = testing::read_bytes(entry.path());
  }
  return files;
}

// Lidar ground of which the west half was not surveyed, and a vegetation index of the same area at half the
// resolution.
void write_survey(const TemporaryFolder& folder) {
  write_raster(folder / "dtm.tif", 100, 100, 1.0, glm::dvec2(702'000.5, 4'333'000.5),
               [](int column, int row) {
                 return column < 50 ? NAN : 300.0f + testing::rolling_height_m(column, row);
               });
  write_raster(folder / "ndvi.tif", 50, 50, 2.0, glm::dvec2(702'001.0, 4'333'001.0), [](int column, int row) {
    return column < 25 ? NAN : row < 10 ? -0.1f : 0.8f;
  });
}

NewSceneRequest request_for(const fs::path& folder) {
  NewSceneRequest request;
  request.folder = folder;
  return request;
}

TEST(NewScene, WritesTheSameBytesEveryTime) {
  const TemporaryFolder folder;
  new_scene(request_for(folder / "a"));
  new_scene(request_for(folder / "deep/er/b"));
  EXPECT_EQ(contents(folder / "a"), contents(folder / "deep/er/b"));
  EXPECT_NO_THROW(World(read_scene(folder / "a", {}), {}));
}

TEST(NewScene, RefusesAFolderThatIsNotEmpty) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "mine");
  testing::write_text(folder / "mine/notes.txt", "keep");
  testing::write_text(folder / "mine/ground.tif", "old");
  EXPECT_THROW(new_scene(request_for(folder / "mine")), UsageError);
  EXPECT_EQ(contents(folder / "mine").size(), 2u);
  NewSceneRequest request = request_for(folder / "mine");
  request.force = true;
  new_scene(request);
  EXPECT_EQ(contents(folder / "mine").size(), 6u);
  EXPECT_EQ(testing::read_bytes(folder / "mine/notes.txt").size(), 4u);
  EXPECT_GT(testing::read_bytes(folder / "mine/ground.tif").size(), 1000u);
}

TEST(NewScene, TakesAnEmptyFolderAndRefusesAFile) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "empty");
  EXPECT_NO_THROW(new_scene(request_for(folder / "empty")));
  testing::write_text(folder / "file", "x");
  EXPECT_THROW(new_scene(request_for(folder / "file")), UsageError);
}

TEST(NewScene, SaysWhereItCannotWrite) {
  EXPECT_THROW(new_scene(request_for("/proc/nowhere/scene")), OutputFailure);
}

TEST(NewScene, RefusesASeedThatASceneFileCannotHold) {
  const TemporaryFolder folder;
  NewSceneRequest request = request_for(folder / "a");
  request.seed = ~std::uint64_t{0};
  EXPECT_THROW(new_scene(request), UsageError);
  EXPECT_FALSE(fs::exists(folder / "a"));
}

TEST(NewScene, StartsFromAPersonsRasters) {
  const TemporaryFolder folder;
  write_survey(folder);
  NewSceneRequest request = request_for(folder / "konza");
  request.height_files = {folder / "dtm.tif"};
  request.density =
      DensityRequest{.file = folder / "ndvi.tif", .range = {{0.2, 0.9}}, .curve = 1.5, .max_per_m2 = 800};
  new_scene(request);
  EXPECT_EQ(testing::read_bytes(folder / "konza/height.tif"), testing::read_bytes(folder / "dtm.tif"));
  EXPECT_EQ(testing::read_bytes(folder / "konza/density.tif"), testing::read_bytes(folder / "ndvi.tif"));

  const World world(read_scene(folder / "konza", {}), {});
  const Meadow& meadow = world.meadow();
  EXPECT_EQ(meadow.extent_m, glm::dvec2(99.0, 99.0));
  const double share = std::pow((0.8 - 0.2) / (0.9 - 0.2), 1.5);
  EXPECT_NEAR(meadow.species[0].density_per_m2.sample({80.0, 60.0}), 800.0 * share, 0.1);
  const CameraSpec& camera = world.scene().cameras.front();
  EXPECT_EQ(camera.name, "default");
  EXPECT_TRUE(is_planted(meadow, camera.position_m));
  EXPECT_GT(camera.position_m.x, 50.0);
  EXPECT_GT(camera.position_m.y, 20.0);
}

TEST(NewScene, HeightAloneGetsAUniformSward) {
  const TemporaryFolder folder;
  write_survey(folder);
  NewSceneRequest request = request_for(folder / "a");
  request.height_files = {folder / "dtm.tif"};
  new_scene(request);
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_TRUE(world.meadow().species[0].density_per_m2.is_uniform());
  EXPECT_TRUE(is_planted(world.meadow(), world.scene().cameras.front().position_m));
}

TEST(NewScene, DensityAloneLiesOnLevelGround) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> grey(32 * 16, 200);
  testing::write_bytes(folder / "painted.png", encode_png_grey8(32, 16, grey));
  NewSceneRequest request = request_for(folder / "a");
  request.density = DensityRequest{.file = folder / "painted.png"};
  EXPECT_THROW(new_scene(request), BadInput) << "nothing says how large a pixel is";
  EXPECT_FALSE(fs::exists(folder / "a"));
  request.height_spacing_m = 2.0;
  new_scene(request);
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(62.0, 30.0));
  EXPECT_NEAR(world.meadow().species[0].density_per_m2.sample({10.0, 10.0}), 1000.0 * 200.0 / 255.0, 0.01);
}

TEST(NewScene, FitsAMaskWithoutAPlaceOntoTheGround) {
  const TemporaryFolder folder;
  std::vector<std::uint16_t> heights;
  for (int k = 0; k < 65 * 33; ++k) heights.push_back(static_cast<std::uint16_t>(1000 + k));
  testing::write_image(folder / "terrain.png", 65, 33, 1, OIIO::TypeDesc::UINT16, heights);
  testing::write_bytes(folder / "mask.png",
                       encode_png_grey8(32, 16, std::vector<std::uint8_t>(32 * 16, 200)));
  NewSceneRequest request = request_for(folder / "a");
  request.height_files = {folder / "terrain.png"};
  request.height_range_m = {{0.0, 100.0}};
  request.height_spacing_m = 1.0;
  request.density = DensityRequest{.file = folder / "mask.png"};
  const std::vector<std::string> said = new_scene(request);
  EXPECT_TRUE(std::ranges::any_of(
      said, [](const std::string& line) { return line.find("fitted to the ground") != std::string::npos; }));
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(64.0, 32.0));
  const NodeGrid& density = world.meadow().species[0].density_per_m2;
  EXPECT_NEAR(density.frame().far_corner_m().x, 64.0, 3.0);
  EXPECT_GT(density.sample({63.9, 31.9}), 0.0f);
  EXPECT_EQ(said.size(), 2u) << "and that all its values are the same";
}

TEST(NewScene, JoinsSeveralHeightFiles) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "tiles");
  for (const int k : {0, 1}) {
    const NodeGrid grid({20, 30, 1.0, {20.0 * k, 0.0}, false}, 1,
                        std::vector<float>(20 * 30, 5.0f + static_cast<float>(k)));
    testing::write_bytes(folder / "tiles" / fmt::format("t{}.tif", k), encode_geotiff(grid, nullptr));
  }
  NewSceneRequest request = request_for(folder / "a");
  request.height_files = {folder / "tiles"};
  new_scene(request);
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(39.0, 29.0));
  EXPECT_NEAR(world.meadow().ground.height_m({5.0, 5.0}), 5.0f, 1e-4f);
  EXPECT_NEAR(world.meadow().ground.height_m({30.0, 5.0}), 6.0f, 1e-4f);
}

TEST(NewScene, TellsWhatItsMapsGaveReasonToWarnOf) {
  const TemporaryFolder folder;
  testing::write_bytes(folder / "dark.png", encode_png_grey8(16, 16, std::vector<std::uint8_t>(256, 0)));
  NewSceneRequest request = request_for(folder / "a");
  request.density = DensityRequest{.file = folder / "dark.png", .spacing_m = 1.0};
  const std::vector<std::string> said = new_scene(request);
  EXPECT_TRUE(std::ranges::any_of(
      said, [](const std::string& line) { return line.find("nothing grows") != std::string::npos; }));
}

TEST(NewScene, TakesOneChannelOfAMask) {
  const TemporaryFolder folder;
  std::vector<std::uint8_t> pixels;
  for (int k = 0; k < 16 * 16; ++k) pixels.insert(pixels.end(), {10, 20, 30, 255});
  testing::write_image(folder / "mask.png", 16, 16, 4, OIIO::TypeDesc::UINT8, pixels);
  NewSceneRequest request = request_for(folder / "a");
  request.density = DensityRequest{.file = folder / "mask.png", .channel = "A", .spacing_m = 1.0};
  new_scene(request);
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_EQ(world.meadow().species[0].density_per_m2.sample({5.0, 5.0}), 1000.0f);
}

TEST(NewScene, BringsTheWorldFileAlong) {
  const TemporaryFolder folder;
  const std::vector<std::uint8_t> grey(32 * 16, 200);
  testing::write_bytes(folder / "painted.png", encode_png_grey8(32, 16, grey));
  testing::write_text(folder / "painted.pgw", "3\n0\n0\n-3\n1000\n2045\n");
  NewSceneRequest request = request_for(folder / "a");
  request.density = DensityRequest{.file = folder / "painted.png"};
  new_scene(request);
  EXPECT_TRUE(fs::exists(folder / "a/density.pgw"));
  const World world(read_scene(folder / "a", {}), {});
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(93.0, 45.0));
  ASSERT_TRUE(world.geo_reference());
  EXPECT_EQ(world.geo_reference()->south_m, 2000.0);
}

TEST(NewScene, RefusesAStrangersWorldFileBesideTheCopy) {
  const TemporaryFolder folder;
  write_survey(folder);
  fs::create_directories(folder / "a");
  testing::write_text(folder / "a/height.tfw", "3\n0\n0\n-3\n1000\n2045\n");
  NewSceneRequest request = request_for(folder / "a");
  request.force = true;
  request.height_files = {folder / "dtm.tif"};
  EXPECT_THROW(new_scene(request), UsageError);
}

TEST(NewScene, LeavesNothingBehindWhenARasterIsBad) {
  const TemporaryFolder folder;
  testing::write_text(folder / "broken.tif", "II*\0 and then nothing");
  NewSceneRequest request = request_for(folder / "a");
  request.height_files = {folder / "broken.tif"};
  try {
    new_scene(request);
    FAIL();
  } catch (const BadInput& fault) {
    EXPECT_EQ(fault.file, (folder / "broken.tif").string()) << "the person's file, not a copy";
  }
  EXPECT_FALSE(fs::exists(folder / "a"));
  request.height_files = {folder / "missing.tif"};
  EXPECT_THROW(new_scene(request), BadInput);
}

TEST(NewScene, CopiesOntoItself) {
  const TemporaryFolder folder;
  write_survey(folder);
  NewSceneRequest request = request_for(folder / "a");
  request.height_files = {folder / "dtm.tif"};
  new_scene(request);
  request.force = true;
  request.height_files = {folder / "a/height.tif"};
  new_scene(request);
  EXPECT_EQ(testing::read_bytes(folder / "a/height.tif"), testing::read_bytes(folder / "dtm.tif"));
}

}  // namespace
}  // namespace prairie
