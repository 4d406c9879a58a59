// Arrows and heat lie where the fields are, and a picture with them differs from one without in colour alone.
#include "render/overlays/field_overlay.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "agents/mover.h"
#include "render/frame/renderer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"
#include "world/motion.h"

namespace prairie {
namespace {

constexpr glm::dvec2 kEyeM(16.0, 10.0);

/// A meadow over which a stone has rolled along x = 16 m, from y = 12 m to 20 m.
World trodden_world(const TemporaryFolder& folder) {
  World world = open_world(meadow_scene(folder));
  const HeightField& ground = world.meadow().ground;
  DrivenMover stone;
  stone.place = stone.before = stone_place(ground, stone.radius_m, {16.0, 12.0}, {0.0, 1.0}, 0.0);
  world.driven().push_back(stone);
  for (double y_m = 12.1; y_m <= 20.0; y_m += 0.1) {
    world.driven()[0].place = stone_place(ground, stone.radius_m, {16.0, y_m}, {0.0, 1.0}, y_m - 12.0);
    world.step(0.05);
  }
  return world;
}

glm::dvec3 eye_above(const World& world) {
  return {kEyeM, static_cast<double>(world.meadow().ground.height_m(kEyeM)) + 2.0};
}

TEST(FieldOverlay, ArrowsPointWhereTheWindBlows) {
  const TemporaryFolder folder;
  World world = open_world(meadow_scene(folder));
  const glm::dvec3 eye_m = eye_above(world);
  EXPECT_TRUE(wind_arrows(world, eye_m).empty()) << "calm air";
  world.motion().set_wind(MeanWind(glm::dvec2(3.0, 4.0)), std::nullopt);
  const std::vector<WindArrow> arrows = wind_arrows(world, eye_m);
  EXPECT_NEAR(static_cast<double>(arrows.size()), 3.1416 * 12.0 * 12.0, 20.0);
  for (const WindArrow& arrow : arrows) {
    const glm::dvec3 place_m = eye_m + glm::dvec3(arrow.middle_from_eye_m);
    EXPECT_NEAR(place_m.z - static_cast<double>(world.meadow().ground.height_m(glm::dvec2(place_m))), 0.3,
                1e-3);
    EXPECT_NEAR(arrow.speed_m_per_s, 5.0f, 1e-4f);
    EXPECT_NEAR(arrow.along_m.y / arrow.along_m.x, 4.0f / 3.0f, 1e-3f);
  }
}

TEST(FieldOverlay, HeatLiesOnTheTrack) {
  const TemporaryFolder folder;
  const World fresh = open_world(meadow_scene(folder));
  EXPECT_TRUE(heat_squares(fresh, eye_above(fresh), FieldOverlay::kTilt).empty());
  const World world = trodden_world(folder);
  const glm::dvec3 eye_m = eye_above(world);
  for (const FieldOverlay overlay : {FieldOverlay::kTilt, FieldOverlay::kRecovery}) {
    const std::vector<HeatSquare> squares = heat_squares(world, eye_m, overlay);
    ASSERT_FALSE(squares.empty());
    float hottest = 0.0f;
    for (const HeatSquare& square : squares) {
      const glm::dvec2 corner_m = glm::dvec2(eye_m) + glm::dvec2(square.corner_from_eye_m);
      EXPECT_NEAR(corner_m.x, 16.0, 1.5);
      EXPECT_NEAR(corner_m.y, 16.0, 5.5);
      EXPECT_NEAR(eye_m.z + static_cast<double>(square.heights_from_eye_m[0]) -
                      static_cast<double>(world.meadow().ground.height_m(corner_m)),
                  0.06, 1e-3);
      for (int n = 0; n < 4; ++n) {
        EXPECT_GE(square.heat[n], 0.0f);
        EXPECT_LE(square.heat[n], 1.0f);
        hottest = std::max(hottest, square.heat[n]);
      }
    }
    EXPECT_GT(hottest, 0.9f);
  }
}

TEST(FieldOverlay, RecoveryCoolsWithTime) {
  const TemporaryFolder folder;
  World world = trodden_world(folder);
  const auto heat = [&] {
    double sum = 0.0;
    for (const HeatSquare& square : heat_squares(world, eye_above(world), FieldOverlay::kRecovery))
      sum += static_cast<double>(square.heat[0] + square.heat[1] + square.heat[2] + square.heat[3]);
    return sum;
  };
  const double just_trodden = heat();
  world.driven().clear();
  for (int n = 0; n < 300; ++n) world.step(0.1);
  EXPECT_LT(heat(), 0.85 * just_trodden);
  EXPECT_GT(heat(), 0.0);
}

class FieldOverlayPicture : public HeadlessTest {};

TEST_F(FieldOverlayPicture, ChangesColoursAlone) {
  const TemporaryFolder folder;
  World world = trodden_world(folder);
  world.motion().set_wind(MeanWind(glm::dvec2(6.0, 0.0)), std::nullopt);
  Camera camera = camera_above(world, kEyeM, 2.0, 0.0, -0.3);
  camera.size_px = {160, 120};
  Renderer renderer(world, PRAIRIE_TEST_SHADERS);
  for (const bool msaa : {false, true}) {
    FrameOptions options;
    options.msaa = msaa;
    const Picture plain = renderer.render(camera, options, 1);
    for (const FieldOverlay overlay : {FieldOverlay::kWind, FieldOverlay::kTilt, FieldOverlay::kRecovery}) {
      options.field_overlay = overlay;
      const Picture shown = renderer.render(camera, options, 1);
      EXPECT_NE(shown.srgb, plain.srgb);
      EXPECT_EQ(shown.cover, plain.cover);
    }
    options.field_overlay = FieldOverlay::kNone;
    EXPECT_EQ(renderer.render(camera, options, 1).srgb, plain.srgb) << "an overlay leaves nothing behind";
  }
}

}  // namespace
}  // namespace prairie
