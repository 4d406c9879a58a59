// The ground has no cracks: rough black ground under a blinding sky, seen from many eyes that look below the
// horizon, leaves no bright pixel. Patches of up to eight levels meet in these pictures.
#include <algorithm>
#include <cmath>
#include <random>

#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

class GroundCracksTest : public HeadlessTest {
 protected:
  TemporaryFolder folder_;
};

std::size_t bright_pixels(const Picture& picture) {
  std::size_t bright = 0;
  for (std::size_t n = 0; n < picture.linear_rgb.size(); n += 3) bright += picture.linear_rgb[n + 1] > 1.0f;
  return bright;
}

/// The highest ray of the picture points 4° below the horizon.
constexpr double kPitch = -0.5236 - 0.07;

TEST_F(GroundCracksTest, SkyDoesNotShineThrough) {
  const World world = open_world(dark_ground_scene(folder_, false));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  std::mt19937 random(61);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 40; ++n) {
    const glm::dvec2 place(300.0 * unit(random) - 20.0, 300.0 * unit(random) - 20.0);
    // Above the hills around: under them an eye could look up a slope, at the sky.
    Camera camera =
        camera_above(world, place, 12.0 + 300.0 * std::pow(unit(random), 3.0), 6.28 * unit(random), kPitch);
    camera.size_px = {320, 240};
    const Picture picture = renderer.render(camera, {Tier::kFlat, false}, 1);
    EXPECT_EQ(bright_pixels(picture), 0u)
        << place.x << ", " << place.y << ", " << camera.eye_m.z << ", yaw " << camera.yaw_rad;
  }
}

TEST_F(GroundCracksTest, HolesWouldShow) {
  // The test's own proof: looking up, every pixel is bright.
  const World world = open_world(dark_ground_scene(folder_, false));
  const Camera camera = camera_above(world, {128.0, 128.0}, 20.0, 0.0, 1.0);
  const Picture picture = Renderer(world, PRAIRIE_TEST_SHADERS).render(camera, {Tier::kFlat, false}, 1);
  EXPECT_EQ(bright_pixels(picture), static_cast<std::size_t>(picture.width * picture.height));
}

TEST_F(GroundCracksTest, SkyDoesNotShineThroughFarFromTheOrigin) {
  const World world = open_world(dark_ground_scene(folder_, true));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  std::mt19937 random(62);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int n = 0; n < 12; ++n) {
    const double away_m = n % 2 == 0 ? 2500.0 : 100000.0;
    const glm::dvec2 place(away_m + 300.0 * unit(random), -away_m + 300.0 * unit(random));
    Camera camera = camera_above(world, place, 12.0 + 50.0 * unit(random), 6.28 * unit(random), kPitch);
    camera.size_px = {320, 240};
    EXPECT_EQ(bright_pixels(renderer.render(camera, {Tier::kFlat, false}, 1)), 0u)
        << place.x << ", " << place.y;
  }
}

}  // namespace
}  // namespace prairie
