// What the bench `scale` walks over: as large, as dense and as hilly as it says.
#include "bench/scale_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <optional>
#include <string>

#include "bench/scale_folder.h"

namespace prairie {
namespace {

/// Runs on the made-up ground, whatever maps are at hand.
class ScaleSceneTest : public ::testing::Test {
 protected:
  ScaleSceneTest() {
    if (const char* data = std::getenv(kVariable); data != nullptr) data_ = data;
    unsetenv(kVariable);
    ground_ = scale_ground(folder_.path());
  }
  ~ScaleSceneTest() override {
    if (data_) setenv(kVariable, data_->c_str(), 1);
  }

  static constexpr const char* kVariable = "PRAIRIE_DATA";
  std::optional<std::string> data_;
  BenchFolder folder_;
  ScaleGround ground_;
};

TEST_F(ScaleSceneTest, TheFieldCarriesABillionBlades) {
  EXPECT_NEAR(expected_blades(scale_world(ground_, {})), 1e9, 1e6);
  EXPECT_NEAR(expected_blades(scale_world(ground_, {.density_factor = 0.1})), 1e8, 1e5);
}

TEST_F(ScaleSceneTest, RepeatedGroundGoesOnBeyondTheMap) {
  const World world = scale_world(ground_, {.repeats = true});
  EXPECT_TRUE(world.meadow().repeats);
  EXPECT_NEAR(expected_blades(world), 1e9, 3e6) << "on one period of the ground";
}

TEST_F(ScaleSceneTest, TheWalkKeepsItsPaceAtEyeHeight) {
  const World world = scale_world(ground_, {});
  for (int frame = 0; frame < kWalkFrames; ++frame) {
    const Camera camera = walk_camera(world, frame);
    const glm::dvec2 place_m(camera.eye_m);
    ASSERT_NEAR(camera.eye_m.z - static_cast<double>(world.meadow().ground.height_m(place_m)), 1.7, 1e-9);
    const glm::dvec2 next_m(walk_camera(world, frame + 1).eye_m);
    ASSERT_NEAR(glm::length(next_m - place_m), 1.4 / 30.0, 1e-9);
  }
}

// The lidar tile's: ± 7.8 m, 6.3° and 20.2°, 208 m.
TEST(ScaleGroundTest, MadeUpGroundHasTheLidarTilesRelief) {
  const Relief relief = relief_of(made_up_prairie());
  EXPECT_NEAR(relief.deviation_m, 7.8, 0.4);
  EXPECT_NEAR(relief.median_slope_deg, 6.3, 0.4);
  EXPECT_NEAR(relief.steep_slope_deg, 20.2, 1.0);
  EXPECT_NEAR(relief.correlation_m, 208.0, 15.0);
}

TEST(ScaleGroundTest, ReliefOfASlopeIsTheSlope) {
  GridFrame frame;
  frame.columns = frame.rows = 50;
  frame.spacing_m = 2.0;
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column)
      heights_m.push_back(2.0f * static_cast<float>(row));
  }
  const Relief relief = relief_of(NodeGrid(frame, 1, heights_m));
  EXPECT_NEAR(relief.median_slope_deg, 45.0, 1e-6);
  EXPECT_NEAR(relief.steep_slope_deg, 45.0, 1e-6);
  EXPECT_NEAR(relief.deviation_m, 2.0 * std::sqrt((50.0 * 50.0 - 1.0) / 12.0), 1e-6);
}

TEST(BenchFolderTest, IsNewAndGoesWithItsContents) {
  std::filesystem::path path;
  {
    const BenchFolder one, other;
    path = one.path();
    EXPECT_NE(path, other.path());
    EXPECT_TRUE(std::filesystem::is_empty(path));
    std::filesystem::create_directory(path / "inside");
  }
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace prairie
