#include "agents/driven_cart.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "animation/heading.h"

namespace prairie {
namespace {

constexpr double kPullMPerS2 = 2.5;
constexpr double kBrakeMPerS2 = 5.0;
constexpr double kRollingMPerS2 = 1.2;    // what slows it when nothing pulls
constexpr double kLeastPullMPerS2 = 0.3;  // it creeps up any slope rather than being stuck on it
constexpr double kGravityMPerS2 = 9.81;
constexpr double kMostTurnedRad = 0.6;
constexpr double kTurningRadPerS = 1.6;
constexpr double kMostSidewaysMPerS2 = 3.0;  // above it wheels would slip
constexpr double kFarthestM = 1e6;

double wanted(double control) {
  return std::isfinite(control) ? std::clamp(control, -1.0, 1.0) : 0.0;
}

double towards(double from, double to, double most) {
  return from + std::clamp(to - from, -most, most);
}

/// Sine of the angle at which the ground rises ahead.
double climb(const DrivenCart& cart, glm::dvec2 forward, const HeightField& ground) {
  const double rise = glm::dot(glm::dvec2(ground.slope(cart.position_m)), forward);
  return rise / std::sqrt(1.0 + rise * rise);
}

double next_speed(const DrivenCart& cart, double drive, double climb, double dt_s) {
  const double speed = cart.speed_m_per_s;
  if (drive == 0.0) return towards(speed, 0.0, kRollingMPerS2 * dt_s);
  if (drive * speed < 0.0) return towards(speed, 0.0, kBrakeMPerS2 * std::abs(drive) * dt_s);
  const double ahead = drive > 0.0 ? 1.0 : -1.0;
  const double gain =
      std::max(kPullMPerS2 * std::abs(drive) - kGravityMPerS2 * ahead * climb, kLeastPullMPerS2);
  return std::clamp(speed + ahead * gain * dt_s, -kMostCartBackingMPerS, kMostCartSpeedMPerS);
}

double most_turned_rad(double speed_m_per_s, double wheelbase_m) {
  const double square = std::max(speed_m_per_s * speed_m_per_s, 1e-6);
  return std::min(kMostTurnedRad, std::atan(kMostSidewaysMPerS2 * wheelbase_m / square));
}

/// Where the middle between the axles comes from (0, 0) and a heading of 0, by a way of the hind axle along
/// an arc.
glm::dvec2 middle_along_arc(double way_m, double turn_rad, double half_base_m) {
  // sin x / x and (1 − cos x) / x, near 0 by their series.
  const double x = turn_rad;
  const bool is_straight = std::abs(x) < 1e-4;
  const double along = is_straight ? 1.0 - x * x / 6.0 : std::sin(x) / x;
  const double aside = is_straight ? 0.5 * x : (1.0 - std::cos(x)) / x;
  return way_m * glm::dvec2(along, aside) + half_base_m * glm::dvec2(std::cos(x) - 1.0, std::sin(x));
}

}  // namespace

DrivenCart driven_on(DrivenCart cart, const CartControls& controls, double dt_s, const HeightField& ground) {
  if (!(dt_s > 0.0)) return cart;
  dt_s = std::min(dt_s, kLongestCartStepS);
  const double wheelbase_m = cart_wheelbase_m(cart.half_width_m);
  const glm::dvec2 forward(std::cos(cart.heading_rad), std::sin(cart.heading_rad));
  const double before = cart.speed_m_per_s;
  cart.speed_m_per_s = next_speed(cart, wanted(controls.drive), climb(cart, forward, ground), dt_s);
  const double most_rad = most_turned_rad(cart.speed_m_per_s, wheelbase_m);
  const double turned_rad =
      towards(cart.turned_rad, wanted(controls.steer) * most_rad, kTurningRadPerS * dt_s);
  cart.turned_rad = std::clamp(turned_rad, -most_rad, most_rad);

  const double way_m = 0.5 * (before + cart.speed_m_per_s) * dt_s;
  const double turn_rad = way_m * std::tan(cart.turned_rad) / wheelbase_m;
  const glm::dvec2 moved_m = middle_along_arc(way_m, turn_rad, 0.5 * wheelbase_m);
  cart.position_m += moved_m.x * forward + moved_m.y * glm::dvec2(-forward.y, forward.x);
  cart.position_m = glm::clamp(cart.position_m, glm::dvec2(-kFarthestM), glm::dvec2(kFarthestM));
  cart.heading_rad = std::remainder(cart.heading_rad + turn_rad, 2.0 * std::numbers::pi);
  cart.rolled_m += way_m;
  return cart;
}

MoverPlace place_of(const DrivenCart& cart, const HeightField& ground) {
  return cart_place(ground, cart.half_width_m, cart.position_m, direction_of(cart.heading_rad));
}

}  // namespace prairie
