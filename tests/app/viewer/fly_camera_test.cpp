#include "app/viewer/fly_camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace prairie {
namespace {

/// Ground that rises 0.2 m per metre to the north.
HeightField slope() {
  GridFrame frame;
  frame.columns = frame.rows = 101;
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    heights_m.insert(heights_m.end(), static_cast<std::size_t>(frame.columns),
                     0.2f * static_cast<float>(row));
  }
  return HeightField(NodeGrid(frame, 1, heights_m));
}

Camera standing_at(double x_m, double y_m, double above_m, const HeightField& ground) {
  Camera camera;
  camera.eye_m = {x_m, y_m, static_cast<double>(ground.height_m({x_m, y_m})) + above_m};
  return camera;
}

Steering forward(bool fast = false) {
  Steering steering;
  steering.forward = 1.0;
  steering.fast = fast;
  return steering;
}

TEST(FlyCamera, WalkingKeepsTheEyeHeight) {
  const HeightField ground = slope();
  FlyCamera camera(standing_at(50.0, 20.0, 1.6, ground), ground);
  ASSERT_TRUE(camera.walks());
  for (int step = 0; step < 100; ++step) camera.move(forward(), 0.1, ground);
  const glm::dvec3 eye_m = camera.camera().eye_m;
  EXPECT_NEAR(eye_m.y, 20.0 + 14.0, 1e-9);
  EXPECT_NEAR(eye_m.z - static_cast<double>(ground.height_m(glm::dvec2(eye_m))), 1.6, 1e-6);
}

TEST(FlyCamera, WalkingIgnoresWhereItLooks) {
  const HeightField ground = slope();
  FlyCamera camera(standing_at(50.0, 20.0, 1.7, ground), ground);
  Steering look_down;
  look_down.turn_up_px = -1e6;
  camera.move(look_down, 0.1, ground);
  camera.move(forward(), 1.0, ground);
  EXPECT_NEAR(camera.camera().eye_m.y, 21.4, 1e-9);
  EXPECT_GT(camera.camera().pitch_rad, -std::numbers::pi / 2.0);
}

TEST(FlyCamera, FliesWhereItLooks) {
  const HeightField ground = slope();
  Camera start = standing_at(50.0, 20.0, 30.0, ground);
  start.yaw_rad = std::numbers::pi / 2.0;
  start.pitch_rad = 0.3;
  FlyCamera camera(start, ground);
  ASSERT_FALSE(camera.walks());
  camera.move(forward(), 1.0, ground);
  const glm::dvec3 way = camera.camera().eye_m - start.eye_m;
  EXPECT_NEAR(glm::dot(glm::normalize(way), start.forward()), 1.0, 1e-9);
}

TEST(FlyCamera, ShiftIsFasterAndTwoKeysAreNot) {
  const HeightField ground = slope();
  const Camera start = standing_at(50.0, 50.0, 30.0, ground);
  const auto distance_m = [&](const Steering& steering) {
    FlyCamera camera(start, ground);
    camera.move(steering, 0.5, ground);
    return glm::distance(camera.camera().eye_m, start.eye_m);
  };
  EXPECT_NEAR(distance_m(forward(true)), 5.0 * distance_m(forward()), 1e-9);
  Steering diagonal = forward();
  diagonal.right = 1.0;
  EXPECT_NEAR(distance_m(diagonal), distance_m(forward()), 1e-9);
}

TEST(FlyCamera, NeverUnderTheGround) {
  const HeightField ground = slope();
  FlyCamera camera(standing_at(50.0, 50.0, 10.0, ground), ground);
  Steering sink;
  sink.up = -1.0;
  for (int step = 0; step < 100; ++step) camera.move(sink, 0.1, ground);
  const glm::dvec3 eye_m = camera.camera().eye_m;
  EXPECT_GT(eye_m.z, static_cast<double>(ground.height_m(glm::dvec2(eye_m))));
}

TEST(FlyCamera, LandsAtEyeHeight) {
  const HeightField ground = slope();
  FlyCamera camera(standing_at(50.0, 50.0, 40.0, ground), ground);
  camera.toggle_walking(ground);
  const glm::dvec3 eye_m = camera.camera().eye_m;
  EXPECT_NEAR(eye_m.z - static_cast<double>(ground.height_m(glm::dvec2(eye_m))), 1.7, 1e-6);
}

}  // namespace
}  // namespace prairie
