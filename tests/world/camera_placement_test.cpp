#include "world/camera_placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace prairie {
namespace {

Meadow meadow_where(const std::function<bool(glm::dvec2)>& grows) {
  GridFrame frame;
  frame.columns = frame.rows = 101;
  std::vector<float> density;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column)
      density.push_back(grows({column, row}) ? 100.0f : 0.0f);
  }
  Meadow meadow;
  meadow.extent_m = {100.0, 100.0};
  meadow.species.emplace_back().density_per_m2 = NodeGrid(frame, 1, std::move(density));
  return meadow;
}

TEST(CameraPlacement, StandsInTheMiddleOfAMeadow) {
  const CameraSpec camera = placed_camera_spec(meadow_where([](glm::dvec2) { return true; }), "default");
  EXPECT_EQ(camera.name, "default");
  EXPECT_EQ(camera.position_m, glm::dvec2(50.0, 50.0));
  EXPECT_EQ(camera.z_m, kEyeHeightM);
  EXPECT_TRUE(camera.z_above_ground);
  EXPECT_LT(camera.pitch_deg, 0.0);
}

TEST(CameraPlacement, LeavesABareMiddleAndLooksOverGrass) {
  const Meadow meadow = meadow_where([](glm::dvec2 p) { return p.x < 20.0; });
  const CameraSpec camera = placed_camera_spec(meadow, "default");
  EXPECT_TRUE(is_planted(meadow, camera.position_m));
  const double yaw_rad = camera.yaw_deg * std::numbers::pi / 180.0;
  EXPECT_TRUE(
      is_planted(meadow, camera.position_m + 30.0 * glm::dvec2(std::sin(yaw_rad), std::cos(yaw_rad))));
}

TEST(CameraPlacement, FindsASmallPatchInACorner) {
  const Meadow meadow = meadow_where([](glm::dvec2 p) { return p.x > 90.0 && p.y < 10.0; });
  EXPECT_TRUE(is_planted(meadow, placed_camera_spec(meadow, "default").position_m));
}

TEST(CameraPlacement, StaysOffUnmeasuredGround) {
  Meadow meadow = meadow_where([](glm::dvec2) { return true; });
  GridFrame frame;
  frame.columns = frame.rows = 101;
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) heights_m.push_back(column < 70 ? NAN : 3.0f);
  }
  meadow.ground = HeightField(NodeGrid(frame, 1, std::move(heights_m)));
  EXPECT_GT(placed_camera_spec(meadow, "default").position_m.x, 70.0);
}

TEST(CameraPlacement, TakesTheMiddleWhereNothingGrows) {
  const CameraSpec camera = placed_camera_spec(meadow_where([](glm::dvec2) { return false; }), "default");
  EXPECT_EQ(camera.position_m, glm::dvec2(50.0, 50.0));
  EXPECT_EQ(camera.yaw_deg, 0.0);
}

}  // namespace
}  // namespace prairie
