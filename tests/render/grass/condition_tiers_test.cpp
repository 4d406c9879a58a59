// What has come over the grass (animation/condition.h) colours all tiers alike.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec3.hpp>
#include <string>

#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

// Without haze, whose colour is the air's, and without sheen, which is the sky's.
constexpr const char* kScene = R"(version = 1
[ground]
size_m = [200, 200]
[[species]]
name = "fescue"
density = 1600
specular = 0
[[species]]
name = "oatgrass"
density = 150
height_m = 0.72
width_mm = 3.0
stiffness = 40
specular = 0
tip_color = "#b59a55"
[sun]
azimuth_deg = 285
elevation_deg = 34
[sky]
haze_per_m = 0
)";
constexpr const char* kBreeze = "[wind]\nspeed_m_per_s = 3\n";
constexpr glm::dvec2 kPlaceM{100.0, 100.0};

/// A few metres of the field, seen from as far as each tier is seen in a meadow.
Camera camera_on_the_field() {
  Camera camera;
  camera.eye_m = glm::dvec3(kPlaceM - 14.0 * glm::dvec2(camera.forward()), 4.0);
  camera.pitch_rad = -std::atan2(4.0, 14.0);
  camera.fov_rad = 0.2;
  camera.size_px = {96, 96};
  return camera;
}

struct View {
  explicit View(const std::string& scene)
      : world(parse_scene(scene, ".", {}), {}), renderer(world, PRAIRIE_TEST_SHADERS) {
    world.watch_anew(kPlaceM);
  }
  Picture picture(Tier tier, int samples) {
    return renderer.render(camera_on_the_field(), {.tier = tier}, samples);
  }

  World world;
  Renderer renderer;
};

glm::dvec3 mean_color(const Picture& picture) {
  glm::dvec3 sum(0.0);
  for (std::size_t n = 0; n < picture.linear_rgb.size(); n += 3)
    sum += glm::dvec3(picture.linear_rgb[n], picture.linear_rgb[n + 1], picture.linear_rgb[n + 2]);
  return sum * (3.0 / static_cast<double>(picture.linear_rgb.size()));
}

class ConditionTiersTest : public HeadlessTest {};

TEST_F(ConditionTiersTest, ColoursAllTiersAlike) {
  constexpr glm::dvec3 kFactor{1.5, 0.8, 0.5};
  const std::string drought =
      "[[condition]]\ncentre_m = [100, 100]\nradius_m = 90000\ncolor_factor = [1.5, 0.8, 0.5]\n";
  struct Case {
    const char* name;
    Tier tier;
  };
  for (const char* wind : {"", kBreeze}) {
    View plain(std::string(kScene) + wind), dry(std::string(kScene) + wind + drought);
    for (const auto& [name, tier] : {Case{"spline", Tier::kSpline}, Case{"hermite", Tier::kHermite},
                                     Case{"strip", Tier::kStrip}, Case{"flat", Tier::kFlat}}) {
      const glm::dvec3 ratio =
          mean_color(dry.picture(tier, 4)) / mean_color(plain.picture(tier, 4)) / kFactor;
      std::printf("%-8s %-6s colour by plain colour and factor: %.4f %.4f %.4f\n", name,
                  *wind == 0 ? "calm" : "breeze", ratio.x, ratio.y, ratio.z);
      // Soil, and what of the litter is not this year's leaves, show between blades and keep their colour:
      // 0.3 % here.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(ratio[c], 1.0, 0.01) << name << " channel " << c;
    }
  }
}

TEST_F(ConditionTiersTest, NeutralOnesChangeNoPixel) {
  const std::string far =
      "[[condition]]\ncentre_m = [9000, 0]\ncolor_factor = [4, 0, 0]\nstiffness_factor = 10\n";
  for (const char* wind : {"", kBreeze}) {
    View plain(std::string(kScene) + wind), conditioned(std::string(kScene) + wind + far);
    for (const Tier tier : {Tier::kSpline, Tier::kStrip, Tier::kFlat})
      EXPECT_EQ(conditioned.picture(tier, 1).srgb, plain.picture(tier, 1).srgb);
  }
}

TEST_F(ConditionTiersTest, FollowsTimeAndEye) {
  View view(
      std::string(kScene) +
      "[[condition]]\ncentre_m = [100, 100]\nradius_m = 50\nstart_s = 0.05\ncolor_factor = [1, 0, 1]\n");
  const auto green = [&] { return mean_color(view.picture(Tier::kHermite, 1)).y; };
  const double before = green();
  view.world.step(0.1);
  const double after = green();
  EXPECT_LT(after, 0.2 * before);
  view.world.motion().watch(kPlaceM + glm::dvec2(3.4, -2.3));
  EXPECT_NEAR(green(), after, 1e-3 * before) << "the eye that watches moved, not the camera";
}

}  // namespace
}  // namespace prairie
