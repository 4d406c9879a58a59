// Scenes from public lidar tiles, where PRAIRIE_DATA names the folder that holds them.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/scenes/info.h"
#include "app/scenes/new_scene.h"
#include "generator/plant.h"
#include "tests/world/scene_texts.h"
#include "world/camera_placement.h"
#include "world/world.h"

namespace prairie {
namespace {

namespace fs = std::filesystem;

class RealScenes : public ::testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("PRAIRIE_DATA");
    if (folder == nullptr) GTEST_SKIP() << "PRAIRIE_DATA is not set to the folder of real maps";
    data_ = folder;
  }

  fs::path real_file(const std::string& name) const { return data_ / name; }

  World new_world(const std::string& height, const std::string& density) {
    NewSceneRequest request;
    request.folder = folder_ / "scene";
    request.height_files = {real_file(height)};
    if (!density.empty()) request.density = DensityRequest{.file = real_file(density)};
    new_scene(request);
    return World(read_scene(request.folder, {}), {});
  }

 private:
  fs::path data_;
  TemporaryFolder folder_;
};

void expect_a_place_to_stand(const World& world) {
  const CameraSpec& camera = world.scene().cameras.front();
  EXPECT_EQ(camera.name, "default");
  EXPECT_TRUE(is_planted(world.meadow(), camera.position_m));
}

TEST_F(RealScenes, KonzaWithItsVegetationIndex) {
  const World world = new_world("konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_DTM.tif",
                                "konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_NDVI.tif");
  const Meadow& meadow = world.meadow();
  EXPECT_EQ(meadow.extent_m, glm::dvec2(999.0, 999.0));
  expect_a_place_to_stand(world);
  const SceneReport report = describe_scene(world);
  EXPECT_NEAR(report.height_m.min_m, 309.6f, 0.1f);
  EXPECT_NEAR(report.height_m.max_m, 367.7f, 0.1f);
  EXPECT_GT(report.expected_blades, 2e8);
  EXPECT_LT(report.expected_blades, 5e8);
  EXPECT_FALSE(report.warnings.empty()) << "half of the map has no data";
}

TEST_F(RealScenes, NoBladeStandsOnKonzasGaps) {
  const World world = new_world("konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_DTM.tif",
                                "konza_neon_1m/NEON_D06_KONZ_DP3_702000_4333000_NDVI.tif");
  const Meadow& meadow = world.meadow();
  std::size_t blades = 0;
  // Columns of tiles across the edge of the survey, at x = 474 m.
  for (int j = 0; j < 250; j += 25) {
    for (int i = 112; i < 128; ++i) {
      const glm::dvec2 origin_m = tile_origin_m(meadow, {i, j});
      for (const Blade& blade : plant_tile(meadow, {i, j})) {
        ++blades;
        const glm::dvec2 root_m = origin_m + glm::dvec2(blade.root_m);
        ASSERT_TRUE(meadow.ground.has_data(root_m, root_m)) << root_m.x << ", " << root_m.y;
        ASSERT_GE(meadow.species[0].density_per_m2.sample(root_m), 0.0f) << root_m.x << ", " << root_m.y;
      }
    }
  }
  EXPECT_GT(blades, 10'000u);
}

TEST_F(RealScenes, NorthernPlains) {
  const World world = new_world("nogp_neon_1m/NEON_D09_NOGP_DP3_350000_5185000_DTM.tif", "");
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(999.0, 999.0));
  expect_a_place_to_stand(world);
  EXPECT_TRUE(world.warnings().empty()) << world.warnings().front().text;
}

TEST_F(RealScenes, SavannaAtFourMetres) {
  const World world = new_world("sjer_neon_4m/sjer_dtmcrop.tif", "");
  EXPECT_EQ(world.meadow().extent_m, glm::dvec2(4.0 * 501, 4.0 * 544));
  expect_a_place_to_stand(world);
  EXPECT_EQ(describe_scene(world).tiles_east, 501);
}

}  // namespace
}  // namespace prairie
