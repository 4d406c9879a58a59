// Gusts, tornadoes and breezes: where they blow, where to, and that they come and go without a step.
#include "animation/wind_primitives.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "files/error.h"

namespace prairie {
namespace {

Gust eastward_gust() {
  return {.origin_m = {10.0, 5.0}, .heading_rad = 0.0, .start_s = 2.0};
}
Tornado standing_tornado() {
  return {
      .origin_m = {-20.0, 30.0}, .travel_m_per_s = 0.0, .wander_m = 0.0, .start_s = 1.0, .duration_s = 20.0};
}
Breeze disc_of_breeze() {
  return {.origin_m = {0.0, 10.0}, .heading_rad = 1.0, .radius_m = 40.0};
}

std::vector<WindPrimitive> all_primitives() {
  Tornado wandering = standing_tornado();
  wandering.travel_m_per_s = 3.0;
  wandering.heading_rad = 2.0;
  wandering.wander_m = 5.0;
  Gust slanted = eastward_gust();
  slanted.heading_rad = 0.7;
  return {eastward_gust(), slanted, standing_tornado(), wandering, disc_of_breeze(), Breeze{}};
}

float speed_of(const WindPrimitive& primitive, glm::dvec2 position_m, double time_s) {
  const glm::vec2 v = velocity_m_per_s(primitive, position_m, time_s);
  return std::sqrt(v.x * v.x + v.y * v.y);
}

TEST(WindPrimitivesTest, NothingOutsideWhatTheyCover) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-120.0, 200.0), when(-2.0, 60.0);
  for (const WindPrimitive& primitive : all_primitives()) {
    int blown = 0;
    for (int n = 0; n < 40000; ++n) {
      const glm::dvec2 position_m(place(random), place(random));
      const double time_s = when(random);
      const auto box = blowing(primitive, time_s);
      const bool inside = box && position_m.x >= box->low_m.x && position_m.y >= box->low_m.y &&
                          position_m.x <= box->high_m.x && position_m.y <= box->high_m.y;
      const float speed = speed_of(primitive, position_m, time_s);
      ASSERT_TRUE(inside || speed == 0.0f) << primitive.index();
      ASSERT_TRUE(time_s < end_s(primitive) || speed == 0.0f) << primitive.index();
      blown += speed > 0.1f;
    }
    EXPECT_GT(blown, 100) << primitive.index();
  }
}

TEST(WindPrimitivesTest, NoStepsInPlaceOrTime) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-60.0, 120.0), when(-1.0, 45.0);
  for (const WindPrimitive& primitive : all_primitives()) {
    for (int n = 0; n < 20000; ++n) {
      const glm::dvec2 position_m(place(random), place(random));
      const double time_s = when(random);
      const glm::vec2 here = velocity_m_per_s(primitive, position_m, time_s);
      const glm::vec2 beside = velocity_m_per_s(primitive, position_m + glm::dvec2(0.007, 0.007), time_s);
      const glm::vec2 later = velocity_m_per_s(primitive, position_m, time_s + 0.001);
      // A tornado's core turns by 10 m/s within a metre.
      ASSERT_LT(std::hypot(beside.x - here.x, beside.y - here.y), 0.2f) << primitive.index();
      ASSERT_LT(std::hypot(later.x - here.x, later.y - here.y), 0.2f) << primitive.index();
    }
  }
}

TEST(WindPrimitivesTest, AGustTravels) {
  const Gust gust = eastward_gust();
  const auto arrival_s = [&](double x_m) {
    for (double t = 0.0; t < 100.0; t += 0.01) {
      if (speed_of(gust, {x_m, 5.0}, t) > 3.0f) return t;
    }
    return 1e9;
  };
  EXPECT_NEAR(arrival_s(150.0) - arrival_s(110.0), 40.0 / gust.travel_m_per_s, 0.05);
  float most = 0.0f;
  for (double t = 0.0; t < 40.0; t += 0.05) most = std::max(most, speed_of(gust, {150.0, 5.0}, t));
  EXPECT_NEAR(most, gust.strength_m_per_s, 0.1);
  EXPECT_EQ(speed_of(gust, {150.0, 36.0}, 18.0), 0.0f) << "beside the front";
}

TEST(WindPrimitivesTest, ATornadoTurnsAndDrawsIn) {
  const Tornado tornado = standing_tornado();
  for (double angle = 0.0; angle < 6.2; angle += 0.3) {
    const glm::dvec2 from_m = tornado.radius_m * glm::dvec2(std::cos(angle), std::sin(angle));
    const glm::dvec2 v(velocity_m_per_s(tornado, tornado.origin_m + from_m, 10.0));
    const double around = (from_m.x * v.y - from_m.y * v.x) / tornado.radius_m;
    const double inward = -(from_m.x * v.x + from_m.y * v.y) / tornado.radius_m;
    EXPECT_NEAR(around, tornado.strength_m_per_s, 0.01);
    EXPECT_NEAR(inward, tornado.inflow * tornado.strength_m_per_s, 0.01);
  }
  EXPECT_EQ(speed_of(tornado, tornado.origin_m, 10.0), 0.0f) << "calm in its eye";
  EXPECT_LT(speed_of(tornado, tornado.origin_m + glm::dvec2(12.0, 0.0), 10.0), 0.5f * 15.0f);
}

TEST(WindPrimitivesTest, ATornadoWandersBySeed) {
  Tornado one = standing_tornado(), other = one;
  one.wander_m = other.wander_m = 5.0;
  other.seed = 2;
  const glm::dvec2 place_m = one.origin_m + glm::dvec2(2.0, 1.0);
  EXPECT_NE(velocity_m_per_s(one, place_m, 8.0), velocity_m_per_s(other, place_m, 8.0));
  EXPECT_NE(velocity_m_per_s(one, place_m, 8.0), velocity_m_per_s(one, place_m, 9.0));
}

TEST(WindPrimitivesTest, ABreezeIsPeriodic) {
  const Breeze breeze = disc_of_breeze();
  const glm::dvec2 place_m(3.0, 4.0);
  for (double t = 0.0; t < 8.0; t += 0.13) {
    EXPECT_NEAR(speed_of(breeze, place_m, t), speed_of(breeze, place_m, t + 5.0 * breeze.period_s), 1e-5f);
    EXPECT_LE(speed_of(breeze, place_m, t), static_cast<float>(breeze.strength_m_per_s) * 1.0001f);
  }
}

TEST(WindPrimitivesTest, BadNumbersAreNamed) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto refused = [](const WindPrimitive& primitive, const std::string& field) {
    try {
      check(primitive, "wind 3");
      ADD_FAILURE() << field << " was accepted";
    } catch (const BadInput& fault) {
      EXPECT_EQ(fault.field, "wind 3: " + field);
    }
  };
  for (const WindPrimitive& good : all_primitives()) check(good, "wind");
  Gust gust;
  gust.width_m = -1.0;
  refused(gust, "width_m");
  gust = {};
  gust.travel_m_per_s = 0.0;
  refused(gust, "travel_m_per_s");
  gust = {};
  gust.origin_m.y = kNan;
  refused(gust, "origin_m");
  Tornado tornado;
  tornado.radius_m = -3.0;
  refused(tornado, "radius_m");
  tornado = {};
  tornado.reach_m = 1.0;
  refused(tornado, "reach_m");
  tornado = {};
  tornado.duration_s = kNan;
  refused(tornado, "duration_s");
  Breeze breeze;
  breeze.period_s = 0.0;
  refused(breeze, "period_s");
  breeze = {};
  breeze.radius_m = -1.0;
  refused(breeze, "radius_m");
}

}  // namespace
}  // namespace prairie
