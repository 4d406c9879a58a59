#include "agents/footing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "agents/skeleton.h"
#include "animation/heading.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kStepS = 1.0 / 60.0;

/// Walks `seconds` with a turn of so much a second; counts how often the left foot strikes, and sees that
/// feet stay where they stand.
struct Walker {
  Footing footing = standing({0.0, 0.0}, {1.0, 0.0}, 1.0);
  BodyStep body;
  double heading_rad = 0.0;
  int left_strikes = 0;
  double first_strike_s = 0.0, last_strike_s = 0.0, time_s = 0.0;

  void walk(double seconds, double speed_m_per_s, double turn_rad_per_s = 0.0) {
    for (double t = 0.0; t < seconds - 1e-9; t += kStepS) {
      heading_rad += turn_rad_per_s * kStepS;
      body.forward = direction_of(heading_rad);
      body.speed_m_per_s = speed_m_per_s;
      body.position_m += speed_m_per_s * kStepS * body.forward;
      const Footing before = footing;
      advance(footing, recorded_gait(), body, kStepS);
      time_s += kStepS;
      for (std::size_t n = 0; n < 2; ++n) {
        if (before.feet[n].planted) {
          EXPECT_EQ(before.feet[n].position_m, footing.feet[n].position_m);
          EXPECT_EQ(before.feet[n].forward, footing.feet[n].forward);
        }
      }
      EXPECT_TRUE(footing.feet[0].planted || footing.feet[1].planted);
      if (!before.feet[0].planted && footing.feet[0].planted) {
        if (left_strikes++ == 0) first_strike_s = time_s;
        last_strike_s = time_s;
      }
    }
  }
  double farthest_m() const {
    double most_m = 0.0;
    for (const Foot& foot : footing.feet)
      most_m = std::max(most_m, glm::distance(foot.position_m, body.position_m));
    return most_m;
  }
};

TEST(Footing, AStrideTakesAsLongAsRecorded) {
  Walker walker;
  walker.walk(20.0, 1.18);
  const double period_s = (walker.last_strike_s - walker.first_strike_s) / (walker.left_strikes - 1);
  EXPECT_NEAR(period_s, 1.10, 0.05 * 1.10);
}

TEST(Footing, FeetKeepBesideTheWayAndAlternate) {
  for (const double speed : {0.2, 0.6, 1.18, 2.0}) {
    Walker walker;
    walker.walk(10.0, speed);
    EXPECT_GT(walker.footing.feet[0].position_m.y, 0.02) << speed;
    EXPECT_LT(walker.footing.feet[1].position_m.y, -0.02) << speed;
    EXPECT_GT(walker.left_strikes, 4) << speed;
    EXPECT_LT(walker.farthest_m(), 0.75) << speed;
  }
}

TEST(Footing, FeetComeTogetherAfterAStop) {
  for (const double speed : {0.3, 1.18, 2.0}) {
    for (int n = 0; n < 12; ++n) {
      Walker walker;
      walker.walk(4.0 + 0.1 * n, speed);
      walker.walk(1.8, 0.0);
      const Footing rested = walker.footing;
      EXPECT_TRUE(rested.feet[0].planted && rested.feet[1].planted) << speed << ' ' << n;
      EXPECT_LT(walker.farthest_m(), 0.22) << speed << ' ' << n;
      walker.walk(2.0, 0.0);
      EXPECT_EQ(walker.footing.feet, rested.feet);
      EXPECT_EQ(walker.footing.speed_m_per_s, 0.0);
    }
  }
}

TEST(Footing, TurnsOnTheSpot) {
  for (const double turn : {0.5, 1.5, 3.0}) {
    Walker walker;
    walker.walk(6.0, 0.0, turn);
    EXPECT_GT(walker.left_strikes, 1) << turn;
    walker.walk(2.0, 0.0);
    for (const Foot& foot : walker.footing.feet) {
      EXPECT_GT(glm::dot(foot.forward, walker.body.forward), 0.85) << turn;
      EXPECT_NEAR(glm::length(foot.forward), 1.0, 1e-6);
    }
    EXPECT_LT(walker.farthest_m(), 0.2) << turn;
  }
}

TEST(Footing, WalksAlongCurves) {
  for (const double turn : {-1.0, 0.4, 1.0}) {
    Walker walker;
    walker.walk(15.0, 1.18, turn);
    EXPECT_LT(walker.farthest_m(), 0.75) << turn;
    EXPECT_GT(walker.left_strikes, 11) << turn;
    EXPECT_LT(walker.left_strikes, 17) << turn;
  }
}

TEST(Footing, AFootLeftBehindHurries) {
  Walker walker;
  walker.walk(3.0, 1.0);
  for (int n = 0; n < 60; ++n) {  // pushed aside at 1 m/s
    walker.body.position_m.y += kStepS;
    walker.walk(kStepS, 1.0);
  }
  EXPECT_LT(walker.farthest_m(), 0.95);
}

TEST(Footing, ABodySetElsewhereStandsThere) {
  Walker walker;
  walker.walk(3.0, 1.18);
  walker.body.position_m += glm::dvec2(100.0, 0.0);
  advance(walker.footing, recorded_gait(), walker.body, kStepS);
  EXPECT_LT(walker.farthest_m(), 0.2);
}

TEST(Footing, IsTheSameEveryTime) {
  Walker a, b;
  for (Walker* walker : {&a, &b}) {
    walker->walk(3.0, 1.4, 0.3);
    walker->walk(1.0, 0.0, 2.0);
    walker->walk(2.0, 0.5, -0.3);
  }
  EXPECT_EQ(a.footing, b.footing);
}

std::string refused_field(const std::function<void(Footing&)>& edit) {
  Footing footing = standing({1.0, 2.0}, {0.0, 1.0}, 1.0);
  edit(footing);
  try {
    check(footing);
  } catch (const BadInput& bad) {
    return bad.field;
  }
  return "nothing";
}

TEST(Footing, WhatCannotBeOneIsRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused_field([](Footing&) {}), "nothing");
  EXPECT_EQ(refused_field([](Footing& f) { f.scale = 0.0; }), "scale");
  EXPECT_EQ(refused_field([](Footing& f) { f.phase = kNan; }), "phase");
  EXPECT_EQ(refused_field([](Footing& f) { f.speed_m_per_s = -1.0; }), "speed_m_per_s");
  EXPECT_EQ(refused_field([](Footing& f) { f.feet[1].position_m.y = kNan; }), "position_m");
  EXPECT_EQ(refused_field([](Footing& f) { f.feet[0].forward = {2.0, 0.0}; }), "forward");
  EXPECT_EQ(refused_field([](Footing& f) { f.feet[0].share = 1.5; }), "share");
  EXPECT_EQ(refused_field([](Footing& f) { f.feet[0].lift_phase = 1.0; }), "lift_phase");
  EXPECT_EQ(refused_field([](Footing& f) { f.feet[0].planted = f.feet[1].planted = false; }), "planted");
}

}  // namespace
}  // namespace prairie
