#include "app/scenes/tile_views.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace prairie {
namespace {

Meadow level_meadow() {
  Meadow meadow;
  meadow.extent_m = {40.0, 40.0};
  PlantedSpecies grass;
  grass.species.params.height_m = 0.5f;
  grass.species.params.height_spread = 0.4f;
  grass.density_per_m2 = NodeGrid::uniform(100.0f);
  meadow.species.push_back(grass);
  return meadow;
}

glm::dvec2 on_screen(const Camera& camera, glm::dvec3 position_m) {
  const glm::vec4 clip = camera.clip_from_eye() * glm::vec4(glm::vec3(position_m - camera.eye_m), 1.0f);
  return glm::dvec2(clip) / static_cast<double>(clip.w);
}

class TileViewShapes : public ::testing::TestWithParam<glm::ivec2> {};

TEST_P(TileViewShapes, TheWholeTileIsInTopAndOblique) {
  const Meadow meadow = level_meadow();
  const TileId tile{4, 7};
  const glm::dvec3 origin_m{tile_origin_m(meadow, tile), 0.0};
  for (const TileView view : {TileView::kTop, TileView::kOblique}) {
    const Camera camera = tile_camera(meadow, tallest_blade_m(meadow), tile, view, GetParam());
    for (const double x : {0.0, meadow.tile_m}) {
      for (const double y : {0.0, meadow.tile_m}) {
        for (const double z : {0.0, 0.7}) {
          const glm::dvec2 seen = on_screen(camera, origin_m + glm::dvec3(x, y, z));
          EXPECT_LE(std::abs(seen.x), 1.0 + 1e-4) << tile_view_name(view);
          EXPECT_LE(std::abs(seen.y), 1.0 + 1e-4) << tile_view_name(view);
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Shapes, TileViewShapes,
                         ::testing::Values(glm::ivec2(512, 512), glm::ivec2(640, 360), glm::ivec2(300, 700)));

TEST(TileViews, TopHasNorthUpAndTheTileFillsTheShorterSide) {
  const Meadow meadow = level_meadow();
  const Camera camera = tile_camera(meadow, tallest_blade_m(meadow), {0, 0}, TileView::kTop, {800, 400});
  EXPECT_NEAR(on_screen(camera, {2.0, 4.0, 0.0}).y, 1.0, 1e-4);
  EXPECT_NEAR(on_screen(camera, {4.0, 2.0, 0.0}).x, 0.5, 1e-4);
}

TEST(TileViews, EyeStandsThreeMetresSouthAndLooksAtTheMiddle) {
  const Meadow meadow = level_meadow();
  const Camera camera = tile_camera(meadow, tallest_blade_m(meadow), {3, 2}, TileView::kEye, {640, 480});
  EXPECT_NEAR(camera.eye_m.x, 14.0, 1e-9);
  EXPECT_NEAR(camera.eye_m.y, 8.0 - 3.0, 1e-9);
  EXPECT_NEAR(camera.eye_m.z, 1.7, 1e-9);
  EXPECT_EQ(camera.yaw_rad, 0.0);
  EXPECT_LT(glm::length(on_screen(camera, {14.0, 10.0, 0.5 * tallest_blade_m(meadow)})), 1e-3);
}

TEST(TileViews, ObliqueLooksDownAtFortyFiveDegrees) {
  const Meadow meadow = level_meadow();
  const Camera camera = tile_camera(meadow, tallest_blade_m(meadow), {3, 2}, TileView::kOblique, {640, 480});
  EXPECT_NEAR(camera.pitch_rad, -0.785398163, 1e-6);
}

}  // namespace
}  // namespace prairie
