// What stands covers the pixels that it should, near the origin and far from it, and costs nothing out of
// sight.
#include "render/things/obstacle_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "render/gl/render_target.h"
#include "render/gl/stream_buffer.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"
#include "tests/render/things/covered_pixels.h"

namespace prairie {
namespace {

class ObstaclePassTest : public HeadlessTest {
 protected:
  /// Which pixels it covers, rows from the top.
  std::vector<bool> covered(const Camera& camera, const StandingThings& things) {
    const World world = open_world(dark_ground_scene(folder_, false));
    pass_.set(things, HeightField());
    return covered_pixels(world, camera, ObstaclePass::kState, [&](StreamBuffer&) {
      pass_.prepare(camera);
      pass_.draw();
    });
  }

  /// From above in a parallel projection, a pixel being a millimetre.
  static Camera above(glm::dvec2 place_m) {
    Camera camera;
    camera.eye_m = {place_m, 10.0};
    camera.pitch_rad = -1.5707963267948966;
    camera.size_px = {400, 400};
    camera.orthographic_height_m = 0.4;
    return camera;
  }

  TemporaryFolder folder_;
  ObstaclePass pass_{PRAIRIE_TEST_SHADERS};
};

TEST_F(ObstaclePassTest, CoversItsOutlineEvenFarFromTheOrigin) {
  // 100 km out floats are 8 mm apart; the corner would be off by pixels.
  for (const double from_origin_m : {0.0, 100'000.0}) {
    const glm::dvec2 corner_m(from_origin_m + 0.123, from_origin_m + 0.456);
    const Block block{corner_m - glm::dvec2(0.5, 0.25), {1.0, 0.5, 1.0}, 0.0};  // its north-eastern corner
    const std::vector<bool> pixels = covered(above(corner_m), {{block}, {}});
    for (int row = 0; row < 400; ++row) {
      for (int column = 0; column < 400; ++column) {
        if (std::abs(column - 200) <= 1 || std::abs(row - 200) <= 1) continue;
        ASSERT_EQ(pixels[static_cast<std::size_t>(400 * row + column)], column < 200 && row > 200)
            << column << ", " << row << " at " << from_origin_m;
      }
    }
  }
}

TEST_F(ObstaclePassTest, WhatIsOutOfSightIsNotDrawn) {
  StandingThings things;
  things.obstacles = {Trunk{{0.0, 10.0}}, Rock{{0.0, 500.0}}, Block{{300.0, 300.0}}};
  Camera camera;
  camera.eye_m = {0.0, 0.0, 1.7};
  covered(camera, things);
  const std::uint64_t ahead = pass_.triangles_drawn();
  camera.yaw_rad = 3.1;
  covered(camera, things);
  EXPECT_GT(ahead, 0u);
  EXPECT_EQ(pass_.triangles_drawn(), 0u);
}

TEST_F(ObstaclePassTest, FarTrunksAreOfFewTrianglesAndCoverTheSame) {
  // Parallel projection: the same pixels, whatever the distance; their size decides.
  std::vector<double> areas_m2;
  std::vector<std::uint64_t> triangles;
  for (const int rows : {800, 120}) {
    Camera camera;
    camera.eye_m = {0.0, -20.0, 1.5};
    camera.size_px = {rows, rows};
    camera.orthographic_height_m = 4.0;
    const auto pixels = std::ranges::count(covered(camera, {{Trunk{{0.0, 0.0}, 0.5, 3.0}}, {}}), true);
    areas_m2.push_back(static_cast<double>(pixels) * camera.pixel_m() * camera.pixel_m());
    triangles.push_back(pass_.triangles_drawn());
  }
  EXPECT_LT(triangles[1], triangles[0] / 4);
  EXPECT_NEAR(areas_m2[1], areas_m2[0], 0.03 * areas_m2[0]);
}

TEST_F(ObstaclePassTest, WhatIsTakenAwayIsGone) {
  Camera camera;
  camera.eye_m = {0.0, -4.0, 1.0};
  EXPECT_GT(std::ranges::count(covered(camera, {{Rock{{0.0, 0.0}}}, {}}), true), 0);
  EXPECT_EQ(std::ranges::count(covered(camera, {}), true), 0);
}

TEST_F(ObstaclePassTest, NothingIsMadeForNothing) {
  ObstaclePass pass("/nowhere");
  pass.set({}, HeightField());
  pass.prepare(Camera{});
  pass.draw();
  EXPECT_EQ(pass.triangles_drawn(), 0u);
}

}  // namespace
}  // namespace prairie
