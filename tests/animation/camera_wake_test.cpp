// The wake of a moving camera.
#include "animation/camera_wake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "files/error.h"

namespace prairie {
namespace {

float speed_at(const CameraWake& wake, glm::dvec2 position_m) {
  const glm::vec2 v = wake.velocity_m_per_s(position_m);
  return std::sqrt(v.x * v.x + v.y * v.y);
}

/// Flies east along y = 0.3 from x = 0 for some seconds.
CameraWake flown(double seconds, double dt_s, double speed_m_per_s = 4.0) {
  CameraWake wake(CameraWakeSettings{});
  const int steps = static_cast<int>(std::lround(seconds / dt_s));
  for (int n = 0; n <= steps; ++n) wake.step({speed_m_per_s * dt_s * n, 0.3}, dt_s * n);
  return wake;
}

TEST(CameraWakeTest, BlowsAwayFromTheCameraAlongItsMotion) {
  const CameraWake wake = flown(2.0, 1.0 / 60.0);
  const glm::vec2 ahead = wake.velocity_m_per_s({10.0, 0.3});
  EXPECT_GT(ahead.x, 0.5f);
  EXPECT_GT(wake.velocity_m_per_s({9.5, 2.3}).y, 0.1f) << "to the left on the left";
  EXPECT_LT(wake.velocity_m_per_s({9.5, -1.7}).y, -0.1f);
  EXPECT_EQ(speed_at(wake, {8.0, 12.0}), 0.0f) << "far to the side";
  EXPECT_EQ(speed_at(wake, {80.0, 0.0}), 0.0f) << "beyond its nodes";
}

TEST(CameraWakeTest, ACameraThatStandsStirsNothing) {
  CameraWake wake(CameraWakeSettings{});
  for (int n = 0; n < 100; ++n) wake.step({1.0, 2.0}, 0.1 * n);
  for (double x = -5.0; x < 5.0; x += 0.5) EXPECT_EQ(speed_at(wake, {x, 2.0}), 0.0f);
}

TEST(CameraWakeTest, DiesDownBySecondsNotByFrames) {
  for (const int steps : {1, 7, 60}) {
    CameraWake wake = flown(2.0, 1.0 / 60.0);
    const double start_s = wake.state().time_s;
    const float before = speed_at(wake, {9.0, 0.3});
    for (int n = 1; n <= steps; ++n) wake.step({8.0, 0.3}, start_s + static_cast<double>(n) / steps);
    EXPECT_NEAR(speed_at(wake, {9.0, 0.3}), before * std::exp(-1.2f), 1e-4f * before) << steps;
  }
}

TEST(CameraWakeTest, TheTimeStepMattersLittle) {
  const CameraWake coarse = flown(2.0, 1.0 / 30.0), fine = flown(2.0, 1.0 / 120.0);
  for (double x = 0.0; x < 14.0; x += 0.7) {
    for (double y = -4.0; y < 4.0; y += 0.7) {
      EXPECT_NEAR(speed_at(coarse, {x, y}), speed_at(fine, {x, y}), 0.03f + 0.02f * speed_at(fine, {x, y}));
    }
  }
}

TEST(CameraWakeTest, WhatWasStirredUpStaysWhereItIs) {
  CameraWake wake = flown(2.0, 1.0 / 60.0);
  const glm::vec2 before = wake.velocity_m_per_s({6.0, 1.0});
  const double time_s = wake.state().time_s;
  // Slowly enough to stir next to nothing, far enough for the nodes to move on.
  CameraWake still = wake;
  wake.step({11.0, 0.3}, time_s + 1e-9);
  EXPECT_NE(wake.state().south_west, still.state().south_west);
  CameraWakeSettings none;
  none.stirring_per_s = 0.0;
  CameraWake carried(none);
  carried.restore(still.state());
  carried.step({11.4, -2.0}, time_s);
  EXPECT_EQ(carried.velocity_m_per_s({6.0, 1.0}), before);
}

TEST(CameraWakeTest, AJumpStirsNothing) {
  CameraWake wake = flown(1.0, 1.0 / 60.0);
  wake.step({5000.0, 0.0}, 1.1);
  for (double x = 4990.0; x < 5010.0; x += 0.9) EXPECT_EQ(speed_at(wake, {x, 0.0}), 0.0f);
}

TEST(CameraWakeTest, SplitRunsEqualOne) {
  const CameraWake whole = flown(2.0, 1.0 / 64.0);
  CameraWake second(CameraWakeSettings{});
  second.restore(flown(1.0, 1.0 / 64.0).state());
  for (int n = 65; n <= 128; ++n) second.step({4.0 / 64.0 * n, 0.3}, n / 64.0);
  EXPECT_TRUE(second.state() == whole.state());
}

TEST(CameraWakeTest, RefusesBadInput) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  CameraWake wake = flown(1.0, 1.0 / 60.0);
  const CameraWakeState before = wake.state();
  EXPECT_THROW(wake.step({1.0, 0.0}, 0.5), BadInput) << "time going backwards";
  EXPECT_THROW(wake.step({1.0, 0.0}, kNan), BadInput);
  EXPECT_THROW(wake.step({kNan, 0.0}, 2.0), BadInput);
  CameraWakeState cut = before;
  cut.velocities_m_per_s.pop_back();
  EXPECT_THROW(wake.restore(cut), BadInput);
  cut = before;
  cut.velocities_m_per_s[3].x = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(wake.restore(cut), BadInput);
  EXPECT_TRUE(wake.state() == before);
  const auto refused = [](auto change) {
    CameraWakeSettings settings;
    change(settings);
    EXPECT_THROW(CameraWake{settings}, BadInput);
  };
  refused([](CameraWakeSettings& settings) { settings.nodes = 32; });
  refused([](CameraWakeSettings& settings) { settings.nodes = 1000001; });
  refused([](CameraWakeSettings& settings) { settings.spread_m = -1.0; });
  refused([](CameraWakeSettings& settings) { settings.damping_per_s = kNan; });
}

}  // namespace
}  // namespace prairie
