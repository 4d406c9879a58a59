// What a person does in a moving world, without a window.
#include "app/viewer/play.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include "world/motion.h"
#include "world/world.h"

namespace prairie {
namespace {

Camera camera() {
  Camera camera;
  camera.eye_m = {8.0, 1.0, 2.0};
  return camera;
}

World small_world(const char* more = "") {
  const std::string scene = R"(version = 1
[ground]
size_m = [64, 64]
[[species]]
name = "grass"
density = 20
)";
  return World(parse_scene(scene + more, ".", {}), {});
}

TEST(PlayClock, TakesEvenStepsAndFallsBehindRatherThanCatchUp) {
  PlayClock clock(false);
  const EvenSteps two = clock.take(0.05);
  EXPECT_EQ(two.count, 2);
  EXPECT_DOUBLE_EQ(two.dt_s, 0.025);
  EXPECT_EQ(clock.take(1.0 / 30.0).count, 1);
  const EvenSteps slow = clock.take(20.0);
  EXPECT_EQ(slow.count, 3);
  EXPECT_NEAR(slow.count * slow.dt_s, PlayClock::kMostPerFrameS, 1e-12);
  for (const double none : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(clock.take(none).count, 0);
  EXPECT_EQ(clock.take(std::numeric_limits<double>::infinity()).count, 3);
}

TEST(PlayClock, StepsSinglyWhileItPauses) {
  PlayClock clock(true);
  EXPECT_EQ(clock.take(0.1).count, 0);
  clock.step_once();
  EXPECT_EQ(clock.take(0.1).count, 1);
  EXPECT_EQ(clock.take(0.1).count, 0);
  clock.toggle_pause();
  clock.step_once();
  EXPECT_EQ(clock.take(0.02).count, 1) << "while time goes there is nothing to step";
}

TEST(WindControls, FollowTheScene) {
  const World calm = small_world();
  EXPECT_EQ(wind_controls_of(calm.scene(), calm.motion().wind()).speed_m_per_s, 0.0f);
  const World world = small_world("[wind]\nspeed_m_per_s = 6\nheading_deg = 200\nturbulence = 0.5\n");
  const WindControls controls = wind_controls_of(world.scene(), world.motion().wind());
  EXPECT_NEAR(controls.speed_m_per_s, 6.0f, 1e-4f);
  EXPECT_NEAR(controls.heading_deg, 200.0f, 1e-3f);
  EXPECT_EQ(controls.turbulence, 0.5f);
}

TEST(WindControls, StepsStayInRange) {
  WindControls controls;
  for (int n = 0; n < 100; ++n) {
    change_speed(controls, +1);
    change_turbulence(controls, +1);
    change_heading(controls, -1);
  }
  EXPECT_EQ(controls.speed_m_per_s, WindControls::kMostSpeedMPerS);
  EXPECT_EQ(controls.turbulence, WindControls::kMostTurbulence);
  EXPECT_GE(controls.heading_deg, 0.0f);
  EXPECT_LT(controls.heading_deg, 360.0f);
  for (int n = 0; n < 100; ++n) {
    change_speed(controls, -1);
    change_turbulence(controls, -1);
  }
  EXPECT_EQ(controls.speed_m_per_s, 0.0f);
  EXPECT_EQ(controls.turbulence, 0.0f);
}

TEST(WindControls, BlowTowardsTheirHeading) {
  World world = small_world();
  blow({5.0f, 180.0f, 0.0f}, world);
  const glm::dvec2 velocity = world.motion().wind().mean.velocity_m_per_s({0.0, 0.0}, 0.0);
  EXPECT_NEAR(velocity.x, 0.0, 1e-5);
  EXPECT_NEAR(velocity.y, -5.0, 1e-5);
  EXPECT_FALSE(world.motion().wind().noise);
}

TEST(Play, GustsComeFromBehindAndTornadoesAhead) {
  World world = small_world();
  Play play(world, true);
  Camera east = camera();
  east.yaw_rad = std::numbers::pi / 2.0;
  play.send_gust(east);
  play.send_tornado(east);
  const std::vector<WindPrimitive>& primitives = world.motion().wind().primitives;
  ASSERT_EQ(primitives.size(), 2u);
  EXPECT_LT(std::get<Gust>(primitives[0]).origin_m.x, east.eye_m.x);
  EXPECT_NEAR(std::get<Gust>(primitives[0]).heading_rad, 0.0, 1e-6);
  EXPECT_NEAR(std::get<Tornado>(primitives[1]).origin_m.x, east.eye_m.x + 15.0, 1e-4);
}

TEST(Play, OneStoneAtATime) {
  World world = small_world();
  Play play(world, false);
  play.roll_stone(camera());
  for (int n = 0; n < 300; ++n) play.advance(0.1, {}, camera());
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_NEAR(world.driven()[0].place.contact_m.y, 1.0 + 4.0 + 40.0, 1e-3);
  EXPECT_GT(world.motion().treading().sample({8.0, 30.0}).tilt_rad, 0.2f);
  play.roll_stone(camera());
  play.advance(0.1, {}, camera());
  ASSERT_EQ(world.driven().size(), 1u);
  EXPECT_LT(world.driven()[0].place.contact_m.y, 6.0);
}

TEST(Play, WhateverAPersonDoesKeepsTheWorldSound) {
  World world = small_world();
  Play play(world, false);
  std::mt19937 random(7);
  using Deed = std::function<void(const Camera&)>;
  const Deed deeds[] = {
      [&](const Camera&) { play.toggle_pause(); },
      [&](const Camera&) { play.step_once(); },
      [&](const Camera& eye) { play.send_gust(eye); },
      [&](const Camera& eye) { play.send_tornado(eye); },
      [&](const Camera& eye) { play.roll_stone(eye); },
      [&](const Camera& eye) { play.take_cart(eye); },
      [&](const Camera&) { play.leave_cart(); },
      [&](const Camera&) {
        play.set_wind({static_cast<float>(random() % 30), 255.0f, 1.5f});
      },
  };
  Camera eye = camera();
  for (int n = 0; n < 60; ++n) {
    if (n == 50) eye.eye_m = {1e7, -1e7, 3.0};
    eye.yaw_rad = 0.1 * n;
    deeds[random() % std::size(deeds)](eye);
    play.advance(0.05, {static_cast<double>(random() % 3) - 1.0, static_cast<double>(random() % 3) - 1.0},
                 eye);
    for (const DrivenMover& driven : world.driven())
      ASSERT_TRUE(std::isfinite(glm::length(driven.place.centre_m)));
  }
}

}  // namespace
}  // namespace prairie
