#include "agents/driven_cart.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

namespace prairie {
namespace {

constexpr double kDtS = 1.0 / 60.0;

/// 100 m × 100 m, the middle at (0, 0).
HeightField ground_of(const std::function<double(glm::dvec2)>& height_m) {
  GridFrame frame;
  frame.columns = frame.rows = 101;
  frame.origin_m = {-50.0, -50.0};
  std::vector<float> heights_m;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column)
      heights_m.push_back(static_cast<float>(height_m(frame.origin_m + glm::dvec2(column, row))));
  }
  return HeightField(NodeGrid(frame, 1, std::move(heights_m)));
}

HeightField slope() {
  return ground_of([](glm::dvec2 p) { return 0.3 * p.x; });
}

DrivenCart driven(DrivenCart cart, const CartControls& controls, double seconds, const HeightField& ground) {
  for (double time_s = 0.0; time_s < seconds; time_s += kDtS) cart = driven_on(cart, controls, kDtS, ground);
  return cart;
}

bool is_sound(const DrivenCart& cart) {
  return std::isfinite(cart.position_m.x) && std::isfinite(cart.position_m.y) &&
         std::abs(cart.heading_rad) < 4.0 && cart.speed_m_per_s <= kMostCartSpeedMPerS &&
         cart.speed_m_per_s >= -kMostCartBackingMPerS && std::abs(cart.turned_rad) < 1.0 &&
         std::isfinite(cart.rolled_m);
}

TEST(DrivenCart, StandsStillWithoutInputAlsoOnASlope) {
  DrivenCart cart;
  cart.heading_rad = 3.0;
  const DrivenCart later = driven(cart, {}, 10.0, slope());
  EXPECT_EQ(later.position_m, cart.position_m);
  EXPECT_EQ(later.heading_rad, cart.heading_rad);
  EXPECT_EQ(later.speed_m_per_s, 0.0);
  const DrivenCart steered = driven(cart, {0.0, 1.0}, 10.0, slope());
  EXPECT_EQ(steered.position_m, cart.position_m) << "wheels that turn do not roll";
}

TEST(DrivenCart, GainsSpeedBrakesAndBacks) {
  const HeightField level;
  const DrivenCart fast = driven({}, {1.0, 0.0}, 5.0, level);
  EXPECT_DOUBLE_EQ(fast.speed_m_per_s, kMostCartSpeedMPerS);
  EXPECT_NEAR(fast.position_m.y, 0.0, 1e-9);
  const DrivenCart coasting = driven(fast, {}, 1.0, level), braking = driven(fast, {-1.0, 0.0}, 0.5, level);
  EXPECT_LT(coasting.speed_m_per_s, fast.speed_m_per_s);
  EXPECT_LT(braking.speed_m_per_s, coasting.speed_m_per_s);
  EXPECT_EQ(driven(fast, {}, 10.0, level).speed_m_per_s, 0.0);
  EXPECT_DOUBLE_EQ(driven(fast, {-1.0, 0.0}, 10.0, level).speed_m_per_s, -kMostCartBackingMPerS);
}

TEST(DrivenCart, IsSlowerUphillAndNeverStuck) {
  DrivenCart up;  // the slope rises to the east
  DrivenCart down;
  down.heading_rad = 3.141592653589793;
  const CartControls pull{0.5, 0.0};
  EXPECT_LT(driven(up, pull, 1.0, slope()).speed_m_per_s, driven(down, pull, 1.0, slope()).speed_m_per_s);
  EXPECT_GT(driven(up, pull, 1.0, slope()).speed_m_per_s, 0.2);
}

// The hind axle's middle goes around a circle of radius L / tan δ, whatever the step.
TEST(DrivenCart, TurnsWithItsRadius) {
  for (const double dt_s : {1.0 / 120.0, 1.0 / 10.0}) {
    DrivenCart cart;
    cart.speed_m_per_s = 1.0;
    const double wheelbase_m = cart_wheelbase_m(cart.half_width_m);
    cart.speed_m_per_s = 1.0;
    cart.turned_rad = 0.3;
    const auto hind_m = [&] {
      return cart.position_m -
             0.5 * wheelbase_m * glm::dvec2(std::cos(cart.heading_rad), std::sin(cart.heading_rad));
    };
    const double radius_m = wheelbase_m / std::tan(0.3);
    const glm::dvec2 middle_m =
        hind_m() + radius_m * glm::dvec2(-std::sin(cart.heading_rad), std::cos(cart.heading_rad));
    for (int n = 0; n < 100; ++n) {
      cart.speed_m_per_s = 1.0;
      // What keeps the wheels at 0.3 rad of the most that they turn at this speed.
      cart = driven_on(cart, {0.0, 0.3 / 0.6}, dt_s, HeightField());
      ASSERT_NEAR(cart.turned_rad, 0.3, 1e-9);
      EXPECT_NEAR(glm::distance(hind_m(), middle_m), radius_m, 1e-9) << dt_s;
    }
  }
}

TEST(DrivenCart, DoesNotSlipAtSpeed) {
  const HeightField level;
  const DrivenCart cart = driven({}, {1.0, 1.0}, 10.0, level);
  const double turn_per_m = std::tan(cart.turned_rad) / cart_wheelbase_m(cart.half_width_m);
  EXPECT_GT(turn_per_m, 0.0);
  EXPECT_LE(cart.speed_m_per_s * cart.speed_m_per_s * turn_per_m, 3.0 + 1e-9);
}

TEST(DrivenCart, KeepsOnTheGround) {
  const HeightField ground =
      ground_of([](glm::dvec2 p) { return 2.0 * std::sin(0.15 * p.x) * std::cos(0.12 * p.y); });
  DrivenCart cart;
  for (int n = 0; n < 600; ++n) {
    cart = driven_on(cart, {1.0, n % 200 < 100 ? 0.4 : -0.4}, kDtS, ground);
    const MoverPlace place = place_of(cart, ground);
    EXPECT_EQ(place.contact_m, cart.position_m);
    EXPECT_NEAR(place.centre_m.z - static_cast<double>(ground.height_m(glm::dvec2(place.centre_m))),
                0.8 * cart.half_width_m, 0.1);
  }
  EXPECT_GT(cart.rolled_m, 15.0);
}

TEST(DrivenCart, TakesNoTimeThatIsNone) {
  DrivenCart cart;
  cart.speed_m_per_s = 3.0;
  for (const double dt_s : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    const DrivenCart later = driven_on(cart, {1.0, 1.0}, dt_s, slope());
    EXPECT_EQ(later.position_m, cart.position_m) << dt_s;
    EXPECT_EQ(later.speed_m_per_s, cart.speed_m_per_s) << dt_s;
  }
  const DrivenCart longest = driven_on(cart, {1.0, 1.0}, kLongestCartStepS, slope());
  EXPECT_EQ(driven_on(cart, {1.0, 1.0}, std::numeric_limits<double>::infinity(), slope()).position_m,
            longest.position_m);
}

TEST(DrivenCart, StaysFiniteWhateverTheKeys) {
  std::mt19937 random(4);
  const double values[] = {0.0,
                           1.0,
                           -1.0,
                           1e300,
                           -1e300,
                           std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity()};
  DrivenCart cart;
  cart.position_m = {999'999.0, -999'999.0};
  for (int n = 0; n < 20'000; ++n) {
    cart = driven_on(cart, {values[random() % 7], values[random() % 7]},
                     0.01 * static_cast<double>(random() % 20), slope());
    ASSERT_TRUE(is_sound(cart)) << n;
  }
}

}  // namespace
}  // namespace prairie
