// Kilometres from the origin pictures are as steady as at home: positions reach the GPU relative to the eye.
//
// A repeating world looks alike everywhere but for its blades and the ground's grain, which depend on the
// place. So statistics are compared: mean colour, and how much the picture changes when the eye moves by a
// millimetre. With positions in world floats, whose steps are 0.24 mm at 2.5 km and 8 mm at 100 km, the
// second would grow many times over.
#include <array>
#include <cmath>

#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

class FarFromOriginTest : public HeadlessTest {
 protected:
  TemporaryFolder folder_;
};

constexpr double kPeriodM = 33.0;  // 33 nodes, 1 m apart

Scene repeating_scene(const TemporaryFolder& folder) {
  Scene scene = meadow_scene(folder);
  scene.height = write_map(folder, "repeating.tif", kPeriodM - 1.0, 1.0, [](glm::dvec2 p) {
    return 5.0 + 0.8 * std::sin(6.2831853 / kPeriodM * p.x) * std::cos(6.2831853 / kPeriodM * p.y);
  });
  scene.height->repeats = true;
  for (SpeciesSpec& species : scene.species) {
    species.density.reset();
    species.uniform_density_per_m2 = 200.0;
  }
  return scene;
}

struct Steadiness {
  std::array<double, 3> mean{};
  double change = 0.0;  // mean |difference| for a millimetre of the eye, linear
};

Steadiness steadiness_at(const World& world, Renderer& renderer, glm::dvec2 place) {
  Camera camera = camera_above(world, place, 1.7, 0.4, -0.3);
  const Picture first = renderer.render(camera, {}, 1);
  camera.eye_m.x += 0.001;
  const Picture second = renderer.render(camera, {}, 1);
  Steadiness result;
  const double values = static_cast<double>(first.linear_rgb.size());
  for (std::size_t n = 0; n < first.linear_rgb.size(); ++n) {
    result.mean[n % 3] += 3.0 * static_cast<double>(first.linear_rgb[n]) / values;
    result.change += static_cast<double>(std::abs(first.linear_rgb[n] - second.linear_rgb[n])) / values;
  }
  return result;
}

TEST_F(FarFromOriginTest, PicturesAreAsSteadyAsAtHome) {
  const World world = open_world(repeating_scene(folder_));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const glm::dvec2 home_m(16.3, 7.7);
  const Steadiness home = steadiness_at(world, renderer, home_m);
  for (const double periods : {76.0, 3030.0}) {  // 2.5 km, 100 km
    const Steadiness away = steadiness_at(world, renderer, home_m + kPeriodM * glm::dvec2(periods, -periods));
    std::printf("%.1f km away: change %.4f, at home %.4f\n", kPeriodM * periods / 1000.0, away.change,
                home.change);
    EXPECT_LE(away.change, 1.5 * home.change);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(away.mean[channel] / home.mean[channel], 1.0, 0.05);
    }
  }
}

}  // namespace
}  // namespace prairie
