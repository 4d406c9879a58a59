// Nothing in a picture is darker than no light, brighter than what shines, or open where ground should be;
// and ground beyond the field looks the same from wherever it is seen.
#include <algorithm>
#include <array>
#include <cmath>

#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"

namespace prairie {
namespace {

constexpr std::array kTiers{Tier::kAuto, Tier::kSpline, Tier::kHermite, Tier::kStrip, Tier::kFlat};

class BoundsTest : public HeadlessTest {
 protected:
  TemporaryFolder folder_;
};

TEST_F(BoundsTest, EveryPixelIsBetweenNoLightAndTheBrightest) {
  const World world = open_world(meadow_scene(folder_));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const float brightest =
      static_cast<float>(world.scene().sun.intensity) *
      std::max({world.scene().sun.color.x, world.scene().sun.color.y, world.scene().sun.color.z});
  for (const Tier tier : kTiers) {
    for (Camera camera :
         {camera_above(world, {8.0, 1.0}, 1.7, 0.2, -0.1), camera_above(world, {8.0, 1.0}, 0.3, 0.6, 0.0),
          camera_above(world, {4.0, -20.0}, 6.0, 0.3, -0.2),
          camera_above(world, {16.0, 16.0}, 60.0, 0.0, -1.5)}) {
      camera.size_px = {480, 270};
      for (const int samples : {1, 4}) {
        const Picture picture = renderer.render(camera, {tier, false}, samples);
        const auto [least, most] = std::ranges::minmax(picture.linear_rgb);
        EXPECT_GE(least, 0.0f) << "tier " << static_cast<int>(tier);
        EXPECT_LE(most, brightest) << "tier " << static_cast<int>(tier);
      }
    }
  }
}

/// Level ground of 40 m with a dense sward, without haze.
Scene small_field() {
  return parse_scene(
      "version = 1\n[ground]\nsize_m = [40, 40]\n[[species]]\nname = \"grass\"\ndensity = 1500\n"
      "[sky]\nhaze_per_m = 0\n",
      ".", {});
}

/// The mean of linear colours over a metre around a place, seen from straight above.
std::array<double, 3> seen_from_above(Renderer& renderer, glm::dvec2 place_m, double above_m, Tier tier) {
  Camera camera;
  camera.eye_m = glm::dvec3(place_m, above_m);
  camera.pitch_rad = -1.5707963267948966;
  camera.size_px = {256, 256};
  camera.fov_rad = 2.0 * std::atan(0.5 / above_m);
  const Picture picture = renderer.render(camera, {tier, false}, 4);
  std::array<double, 3> sum{};
  for (std::size_t k = 0; k < picture.linear_rgb.size(); ++k)
    sum[k % 3] += static_cast<double>(picture.linear_rgb[k]);
  for (double& value : sum) value /= 256.0 * 256.0;
  return sum;
}

TEST_F(BoundsTest, GroundBeyondTheFieldLooksTheSameFromNearAndFar) {
  const World world = open_world(small_field());
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  const glm::dvec2 beyond_m(70.0, 20.0);
  const std::array<double, 3> expected = seen_from_above(renderer, beyond_m, 20.0, Tier::kFlat);
  double worst = 0.0;
  for (const Tier tier : kTiers) {
    for (const double above_m : {2.0, 8.0, 30.0, 120.0, 200.0}) {
      const std::array<double, 3> seen = seen_from_above(renderer, beyond_m, above_m, tier);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const double off = std::abs(seen[channel] / expected[channel] - 1.0);
        worst = std::max(worst, off);
        EXPECT_LT(off, 0.03) << above_m << " m up, tier " << static_cast<int>(tier);
      }
    }
  }
  RecordProperty("worst_share", std::to_string(worst));
}

TEST_F(BoundsTest, GroundIsClosedBeforeAnEyeAmongTheRoots) {
  const World world = open_world(dark_ground_scene(folder_, false));
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  for (const double above_m : {0.02, 0.05, 0.2, 1.7, 30.0}) {
    Camera camera = camera_above(world, {16.0, 16.0}, above_m, 0.4, -1.2);
    camera.size_px = {320, 180};
    const Picture picture = renderer.render(camera, {}, 1);
    // Looking down by 69° at ground that is black under a blinding sky.
    EXPECT_LT(*std::ranges::max_element(picture.linear_rgb), 0.05f) << above_m;
  }
}

}  // namespace
}  // namespace prairie
