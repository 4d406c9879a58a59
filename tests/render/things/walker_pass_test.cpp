// Walkers cover the pixels before their bones in every phase of the gait, without holes, and cost what their
// size asks for.
#include "render/things/walker_pass.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "render/gl/render_target.h"
#include "tests/render/headless_test.h"
#include "tests/render/test_world.h"
#include "tests/render/things/covered_pixels.h"
#include "tests/render/things/walking.h"

namespace prairie {
namespace {

class WalkerPassTest : public HeadlessTest {
 protected:
  /// Which pixels walkers on their own cover, rows from the top.
  std::vector<bool> covered(const Camera& camera, std::span<const WalkerLook> walkers) {
    const World world = open_world(dark_ground_scene(folder_, false));
    return covered_pixels(world, camera, WalkerPass::kState, [&](StreamBuffer& stream) {
      pass_.prepare(stream, walkers, camera, 0.3f);
      pass_.draw();
    });
  }

  /// At the origin from so far in the south, 1 m above the ground.
  static Camera camera_at(double distance_m, glm::ivec2 size_px) {
    Camera camera;
    camera.eye_m = {0.0, -distance_m, 1.0};
    camera.size_px = size_px;
    return camera;
  }

  static bool covers(const std::vector<bool>& pixels, const Camera& camera, glm::dvec3 place_m) {
    const glm::dvec3 from_eye_m = place_m - camera.eye_m;
    const double depth_px = glm::dot(from_eye_m, camera.forward()) * camera.pixel_m();
    const auto column =
        static_cast<int>(0.5 * camera.size_px.x + glm::dot(from_eye_m, camera.right()) / depth_px);
    const auto row = static_cast<int>(0.5 * camera.size_px.y - glm::dot(from_eye_m, camera.up()) / depth_px);
    // A pixel beside it will do: the ends of feet are smaller than pixels far away.
    for (int y = row - 1; y <= row + 1; ++y) {
      for (int x = column - 1; x <= column + 1; ++x) {
        const bool is_here = y == row && x == column;
        if ((is_here || depth_px > kCoarsePixelM) &&
            pixels[static_cast<std::size_t>(y * camera.size_px.x + x)])
          return true;
      }
    }
    return false;
  }
  static constexpr double kCoarsePixelM = 0.02;

  TemporaryFolder folder_;
  WalkerPass pass_{PRAIRIE_TEST_SHADERS};
};

TEST_F(WalkerPassTest, EveryBoneIsInsideTheFigure) {
  const HeightField level;
  for (const double distance_m : {4.0, 12.0, 25.0}) {
    const Camera camera = camera_at(distance_m, {480, 480});
    for (const double heading : {0.0, 1.1, 3.5}) {
      for (int phase = 0; phase < 6; ++phase) {
        const WalkerLook walker =
            walking(level, {0.0, 0.0}, heading, phase == 0 ? 0.0 : 1.4, 3.0 + 0.17 * phase);
        const std::vector<bool> pixels = covered(camera, {&walker, 1});
        for (std::size_t n = 0; n < kJointCount; ++n) {
          const glm::dvec3 from_m = walker.pose[index_of(kRestSkeleton[n].parent)].place_m;
          for (double t = 0.0; t <= 1.0; t += 0.125) {
            EXPECT_TRUE(covers(pixels, camera, from_m + t * (walker.pose[n].place_m - from_m)))
                << "bone " << n << " at " << t << ", heading " << heading << ", phase " << phase << ", "
                << distance_m << " m";
          }
        }
      }
    }
  }
}

TEST_F(WalkerPassTest, LevelsOfDetailCoverTheSame) {
  const HeightField level;
  // Parallel projection: the same pixels, whatever the level; its height in pixels decides.
  std::vector<double> areas_m2;
  for (const int rows : {640, 200, 60}) {
    Camera camera = camera_at(20.0, {rows, rows});
    camera.orthographic_height_m = 2.2;
    const WalkerLook walker = walking(level, {0.0, 0.0}, 0.3, 1.2, 4.0);
    const std::vector<bool> pixels = covered(camera, {&walker, 1});
    const double pixel_m = camera.pixel_m();
    areas_m2.push_back(static_cast<double>(std::ranges::count(pixels, true)) * pixel_m * pixel_m);
  }
  EXPECT_NEAR(areas_m2[1], areas_m2[0], 0.04 * areas_m2[0]);
  EXPECT_NEAR(areas_m2[2], areas_m2[0], 0.12 * areas_m2[0]);
}

TEST_F(WalkerPassTest, FarWalkersAreOfFewTriangles) {
  const HeightField level;
  const WalkerLook walker = walking(level, {0.0, 0.0}, 0.3, 1.2, 4.0);
  std::uint64_t last = 100'000;
  for (const double distance_m : {3.0, 10.0, 60.0}) {
    covered(camera_at(distance_m, {640, 480}), {&walker, 1});
    EXPECT_LT(pass_.triangles_drawn(), last / 3);
    EXPECT_GT(pass_.triangles_drawn(), 100u);
    last = pass_.triangles_drawn();
  }
}

TEST_F(WalkerPassTest, WhoIsOutOfSightIsNotDrawn) {
  const HeightField level;
  const WalkerLook walker = walking(level, {0.0, 0.0}, 0.3, 1.2, 4.0);
  Camera camera = camera_at(10.0, {320, 240});
  camera.yaw_rad = 2.0;
  covered(camera, {&walker, 1});
  EXPECT_EQ(pass_.triangles_drawn(), 0u);
}

TEST_F(WalkerPassTest, NothingIsMadeForNothing) {
  StreamBuffer stream(std::size_t{1} << 10);
  WalkerPass pass("/nowhere");
  pass.prepare(stream, {}, Camera{}, 0.3f);
  pass.draw();
  EXPECT_EQ(pass.triangles_drawn(), 0u);
}

}  // namespace
}  // namespace prairie
