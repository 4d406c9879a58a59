#include "app/scenes/camera_option.h"

#include <gtest/gtest.h>

#include "app/scenes/open_world.h"
#include "app/terminal/usage_error.h"
#include "tests/app/small_scene.h"
#include "tests/maps/test_images.h"
#include "world/world.h"

namespace prairie {
namespace {

World small_world(const TemporaryFolder& folder) {
  testing::write_small_scene(folder.path());
  return open_world(folder.path(), {});
}

TEST(CameraOption, NumbersInMetresAndDegrees) {
  const TemporaryFolder folder;
  const World world = small_world(folder);
  const CameraSpec spec = camera_option("1.5,-2,3,90,-10,45", world);
  EXPECT_EQ(spec.position_m, glm::dvec2(1.5, -2.0));
  EXPECT_EQ(spec.z_m, 3.0);
  EXPECT_FALSE(spec.z_above_ground);
  EXPECT_EQ(spec.fov_deg, 45.0);
  const Camera camera = placed_camera(spec, world, {320, 200});
  EXPECT_EQ(camera.eye_m, glm::dvec3(1.5, -2.0, 3.0));
  EXPECT_NEAR(camera.forward().x, 0.9848, 1e-4) << "yaw 90 looks east";
  EXPECT_LT(camera.forward().z, 0.0);
  EXPECT_EQ(camera.size_px, glm::ivec2(320, 200));
}

TEST(CameraOption, SignMeansAboveTheGround) {
  const TemporaryFolder folder;
  const World world = small_world(folder);
  const Camera camera = placed_camera(camera_option("8,8,+1.7,0,0", world), world, {320, 200});
  EXPECT_DOUBLE_EQ(camera.eye_m.z, static_cast<double>(world.meadow().ground.height_m({8.0, 8.0})) + 1.7);
  EXPECT_NEAR(camera.fov_rad, 1.0472, 1e-4);
}

TEST(CameraOption, NamesOfTheScene) {
  const TemporaryFolder folder;
  const World world = small_world(folder);
  EXPECT_EQ(camera_option("default", world).pitch_deg, -10.0);
  EXPECT_THROW(camera_option("north", world), UsageError);
  EXPECT_THROW(camera_option("", world), UsageError);
}

}  // namespace
}  // namespace prairie
