// The camera behind walkers and about them.
#include "app/viewer/walker_camera.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "tests/app/viewer/walking_world.h"
#include "world/world.h"

namespace prairie {
namespace {

using testing::replaying_world;
using testing::walking_world;

constexpr double kFrameS = 1.0 / 30.0;

/// South of everybody, 10 m up.
Camera above() {
  Camera camera;
  camera.eye_m = {30.0, 10.0, 10.0};
  camera.pitch_rad = -0.4;
  return camera;
}

void pass(WalkerCamera& camera, const World& world, double time_s, const Steering& steering = {}) {
  for (double t = 0.0; t < time_s; t += kFrameS) camera.move(steering, kFrameS, world);
}

/// Cosine of the angle between where the camera looks and the walker's chest.
double looks_at(const Camera& camera, const World& world, std::size_t walker) {
  const glm::dvec3 chest_m(world.walkers()[walker].position_m, 0.7 * world.walker_traits()[walker].height_m);
  return glm::dot(glm::normalize(chest_m - camera.eye_m), camera.forward());
}

double far_m(const Camera& camera, const World& world, std::size_t walker) {
  return glm::distance(glm::dvec2(camera.eye_m), world.walkers()[walker].position_m);
}

TEST(WalkerCamera, WatchesTheOneInTheMiddleFirst) {
  const World world = walking_world();
  for (std::size_t n = 0; n < 3; ++n) {
    Camera start = above();
    const glm::dvec3 way_m = glm::dvec3(world.walkers()[n].position_m, 1.0) - start.eye_m;
    start.yaw_rad = std::atan2(way_m.x, way_m.y);
    start.pitch_rad = std::atan2(way_m.z, glm::length(glm::dvec2(way_m)));
    WalkerCamera camera(start, world, std::nullopt);
    EXPECT_FALSE(camera.watched());
    camera.watch_next(world);
    EXPECT_EQ(camera.watched(), n);
    EXPECT_EQ(camera.mode(), CameraMode::kFree);
    for (std::size_t next = 1; next <= 3; ++next) {
      camera.watch_next(world);
      EXPECT_EQ(camera.watched(), (n + next) % 3);
    }
  }
}

TEST(WalkerCamera, StaysFreeWhereNobodyWalks) {
  const World world(testing::walking_scene(""), {});
  WalkerCamera camera(above(), world, 0);
  camera.watch_next(world);
  camera.change_mode(world);
  EXPECT_FALSE(camera.watched());
  EXPECT_EQ(camera.mode(), CameraMode::kFree);
  pass(camera, world, 1.0);
  EXPECT_EQ(camera.camera().eye_m, above().eye_m);
}

TEST(WalkerCamera, FollowsAtOnceFromTheStart) {
  const World world = walking_world();
  const WalkerCamera camera(above(), world, 1);
  EXPECT_EQ(camera.mode(), CameraMode::kFollow);
  EXPECT_EQ(camera.watched(), 1u);
  EXPECT_NEAR(looks_at(camera.camera(), world, 1), 1.0, 1e-9);
  const Walker& walker = world.walkers()[1];
  const glm::dvec2 way_m = walker.position_m - glm::dvec2(camera.camera().eye_m);
  EXPECT_NEAR(glm::dot(glm::normalize(way_m), walker.forward), 1.0, 1e-9) << "behind it";
  EXPECT_GT(camera.camera().eye_m.z, 0.7 * world.walker_traits()[1].height_m) << "above it";
  const WalkerCamera nobody(above(), world, 3);
  EXPECT_EQ(nobody.mode(), CameraMode::kFree);
  EXPECT_FALSE(nobody.watched());
}

TEST(WalkerCamera, GlidesBehindTheWatchedWalker) {
  World world = walking_world();
  WalkerCamera camera(above(), world, std::nullopt);
  camera.watch_next(world);
  camera.change_mode(world);
  ASSERT_EQ(camera.mode(), CameraMode::kFollow);
  glm::dvec3 last_m = camera.camera().eye_m;
  EXPECT_EQ(last_m, above().eye_m);
  double most_m = 0.0;
  for (double t = 0.0; t < 6.0; t += kFrameS) {
    world.step(kFrameS);
    camera.move({}, kFrameS, world);
    most_m = std::max(most_m, glm::distance(last_m, camera.camera().eye_m));
    last_m = camera.camera().eye_m;
  }
  EXPECT_LT(most_m, 6.0) << "jumped";
  const std::size_t watched = camera.watched().value();
  EXPECT_GT(looks_at(camera.camera(), world, watched), std::cos(glm::radians(6.0)));
  EXPECT_NEAR(far_m(camera.camera(), world, watched), 4.3, 0.5);
}

TEST(WalkerCamera, TurnsAboutTheWatchedWalker) {
  const World world = walking_world();
  WalkerCamera camera(above(), world, 0);
  Steering drag;
  drag.turn_right_px = 100.0;
  const Camera followed = camera.camera();
  pass(camera, world, 0.1, drag);
  EXPECT_NEAR(glm::distance(camera.camera().eye_m, followed.eye_m), 0.0, 1e-9)
      << "dragging turns about it only";
  camera.change_mode(world);
  ASSERT_EQ(camera.mode(), CameraMode::kOrbit);
  camera.move(drag, kFrameS, world);
  EXPECT_NEAR(std::remainder(camera.camera().yaw_rad - followed.yaw_rad - 0.3, 6.283185307179586), 0.0, 1e-9);
  EXPECT_NEAR(looks_at(camera.camera(), world, 0), 1.0, 1e-9);
  EXPECT_NEAR(far_m(camera.camera(), world, 0), far_m(followed, world, 0), 1e-9);
}

TEST(WalkerCamera, WheelAndKeysChangeTheDistance) {
  const World world = walking_world();
  WalkerCamera camera(above(), world, 0);
  const double first_m = far_m(camera.camera(), world, 0);
  Steering nearer;
  nearer.wheel = 3.0;
  camera.move(nearer, kFrameS, world);
  pass(camera, world, 3.0);
  EXPECT_NEAR(far_m(camera.camera(), world, 0), first_m * std::exp(-0.45), 1e-3);
  Steering farther;
  farther.up = 1.0;
  pass(camera, world, 20.0, farther);
  EXPECT_LT(far_m(camera.camera(), world, 0), 100.0);
  EXPECT_GT(far_m(camera.camera(), world, 0), 60.0);
  nearer.wheel = 1e6;
  camera.move(nearer, kFrameS, world);
  pass(camera, world, 5.0);
  EXPECT_GT(far_m(camera.camera(), world, 0), 0.5);
}

TEST(WalkerCamera, NeverUnderTheGround) {
  const World world = walking_world();
  WalkerCamera camera(above(), world, 0);
  camera.change_mode(world);
  Steering lower;
  lower.turn_up_px = 1e6;
  lower.up = 1.0;
  for (int n = 0; n < 300; ++n) {
    camera.move(lower, kFrameS, world);
    const glm::dvec3 eye_m = camera.camera().eye_m;
    ASSERT_GT(eye_m.z - static_cast<double>(world.meadow().ground.height_m(glm::dvec2(eye_m))), 0.29);
  }
  EXPECT_NEAR(looks_at(camera.camera(), world, 0), 1.0, 1e-6) << "lifted, it still looks at the walker";
}

TEST(WalkerCamera, StaysWhereItIsWhenItIsFreeAgain) {
  const World world = walking_world();
  WalkerCamera camera(above(), world, 0);
  camera.change_mode(world);
  const Camera bound = camera.camera();
  camera.change_mode(world);
  EXPECT_EQ(camera.mode(), CameraMode::kFree);
  EXPECT_EQ(camera.watched(), 0u);
  camera.move({}, kFrameS, world);
  EXPECT_NEAR(glm::distance(camera.camera().eye_m, bound.eye_m), 0.0, 1e-6);
  EXPECT_EQ(camera.camera().yaw_rad, bound.yaw_rad);
  EXPECT_EQ(camera.camera().pitch_rad, bound.pitch_rad);
}

TEST(WalkerCamera, WatchesThoseWhoArePresent) {
  World world = replaying_world();
  WalkerCamera camera(above(), world, std::nullopt);
  camera.watch_next(world);
  EXPECT_EQ(camera.watched(), 0u);
  camera.watch_next(world);
  EXPECT_EQ(camera.watched(), 0u) << "the other one is not there yet";
  while (world.time_s() < 6.0) world.step(0.1);
  camera.watch_next(world);
  EXPECT_EQ(camera.watched(), 1u);
  const WalkerCamera later(above(), replaying_world(), 1);
  EXPECT_EQ(later.mode(), CameraMode::kFree);
  EXPECT_EQ(later.watched(), 1u);
  camera.change_mode(world);
  pass(camera, world, 3.0);
  while (world.time_s() < 11.0) world.step(0.1);
  const Camera before = camera.camera();
  pass(camera, world, 1.0);
  EXPECT_NEAR(glm::distance(camera.camera().eye_m, before.eye_m), 0.0, 0.05) << "looks where the walker was";
}

}  // namespace
}  // namespace prairie
