#include "animation/wind_primitives.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "animation/heading.h"
#include "animation/range_check.h"
#include "shaders/kernels/kernels.h"

namespace prairie {
namespace {

// Share of a gust's depth in which it rises.
constexpr double kRise = 0.2;

// Share of a mask's half width from where it fades.
constexpr double kFadeFrom = 0.6;

// In which a tornado comes up and dies down.
constexpr double kComeUpS = 2.0;

// Two periods in this ratio never close a figure.
constexpr double kGolden = 1.618033988749895;

float ramp(double x) {
  return Kernels{}.smooth_ramp(static_cast<float>(x));
}

/// 1 inside, 0 from `outer` on.
float inside(double distance, double outer) {
  return 1.0f - ramp((distance / outer - kFadeFrom) / (1.0 - kFadeFrom));
}

using Blowing = BlowingPrimitive;

std::optional<Blowing> at_time(const Gust& gust, double time_s) {
  const double at_m = gust.travel_m_per_s * (time_s - gust.start_s);
  if (at_m <= 0.0 || at_m >= gust.way_m) return std::nullopt;
  Blowing now{};
  const double fade_m = std::min(gust.depth_m, 0.5 * gust.way_m);
  now.strength = ramp(at_m / fade_m) * ramp((gust.way_m - at_m) / fade_m);
  now.forward = direction_of(gust.heading_rad);
  now.centre_m = gust.origin_m + at_m * now.forward;
  const glm::dvec2 tail_m = now.centre_m - gust.depth_m * now.forward;
  const glm::dvec2 side_m = 0.5 * gust.width_m * glm::abs(glm::dvec2(now.forward.y, now.forward.x));
  now.low_m = glm::min(now.centre_m, tail_m) - side_m;
  now.high_m = glm::max(now.centre_m, tail_m) + side_m;
  return now;
}

glm::vec2 velocity(const Gust& gust, const Blowing& now, glm::dvec2 position_m) {
  const glm::dvec2 from_m = position_m - now.centre_m;
  const double behind = -glm::dot(from_m, now.forward) / gust.depth_m;
  const double across_m = std::abs(now.forward.x * from_m.y - now.forward.y * from_m.x);
  if (behind <= 0.0 || behind >= 1.0 || across_m >= 0.5 * gust.width_m) return glm::vec2(0.0f);
  const float along = ramp(behind / kRise) * (1.0f - ramp((behind - kRise) / (1.0 - kRise)));
  const float mask = along * inside(across_m, 0.5 * gust.width_m) * now.strength;
  return glm::vec2(now.forward * gust.strength_m_per_s) * mask;
}

std::optional<Blowing> at_time(const Tornado& tornado, double time_s) {
  const double age_s = time_s - tornado.start_s;
  if (age_s <= 0.0 || age_s >= tornado.duration_s) return std::nullopt;
  Blowing now{};
  const double come_up_s = std::min(kComeUpS, 0.5 * tornado.duration_s);
  now.strength = ramp(age_s / come_up_s) * ramp((tornado.duration_s - age_s) / come_up_s);
  now.forward = direction_of(tornado.heading_rad);
  const double phase = static_cast<double>(Kernels{}.unit_from_u32(Kernels{}.hash_u32(tornado.seed)));
  const double turns = age_s / tornado.wander_s;
  const glm::dvec2 wander(sine_of_turns(turns + phase), sine_of_turns(turns / kGolden + kGolden * phase));
  now.centre_m = tornado.origin_m + tornado.travel_m_per_s * age_s * now.forward + tornado.wander_m * wander;
  now.low_m = now.centre_m - tornado.reach_m;
  now.high_m = now.centre_m + tornado.reach_m;
  return now;
}

glm::vec2 velocity(const Tornado& tornado, const Blowing& now, glm::dvec2 position_m) {
  const glm::dvec2 from_m = position_m - now.centre_m;
  const double r_m = glm::length(from_m);
  if (r_m >= tornado.reach_m) return glm::vec2(0.0f);
  const double q2 = glm::dot(from_m, from_m) / (tornado.radius_m * tornado.radius_m);
  // Speed by distance from the eye, where the direction is undefined and the speed is 0.
  const double turning_per_s = 2.0 * tornado.strength_m_per_s / (tornado.radius_m * (1.0 + q2));
  const double inflow_per_s = tornado.inflow * std::abs(turning_per_s);
  const glm::dvec2 v(-from_m.y * turning_per_s - from_m.x * inflow_per_s,
                     from_m.x * turning_per_s - from_m.y * inflow_per_s);
  return glm::vec2(v) * (now.strength * inside(r_m, tornado.reach_m));
}

std::optional<Blowing> at_time(const Breeze& breeze, double) {
  constexpr double kEverywhere = 1e300;
  const double reach_m = breeze.radius_m == 0.0 ? kEverywhere : breeze.radius_m;
  Blowing now{};
  now.strength = 1.0f;
  now.forward = direction_of(breeze.heading_rad);
  now.centre_m = breeze.origin_m;
  now.low_m = breeze.origin_m - reach_m;
  now.high_m = breeze.origin_m + reach_m;
  return now;
}

glm::vec2 velocity(const Breeze& breeze, const Blowing& now, glm::dvec2 position_m) {
  const glm::dvec2 from_m = position_m - now.centre_m;
  const double turns = now.time_s / breeze.period_s - glm::dot(from_m, now.forward) / breeze.wavelength_m;
  float strength = static_cast<float>(breeze.strength_m_per_s * (0.5 + 0.5 * sine_of_turns(turns)));
  if (breeze.radius_m > 0.0) strength *= inside(glm::length(from_m), breeze.radius_m);
  return glm::vec2(now.forward) * strength;
}

/// Checks a primitive's numbers one by one.
class Checker {
 public:
  explicit Checker(const std::string& name) : name_(name) {}

  void number(const char* field, double value, double low, double high) const {
    check_range(name_ + ": " + field, value, low, high);
  }
  void place(const char* field, glm::dvec2 place_m) const {
    number(field, place_m.x, -1e7, 1e7);
    number(field, place_m.y, -1e7, 1e7);
  }
  void length(const char* field, double value) const { number(field, value, 0.01, 1e5); }
  void speed(const char* field, double value) const { number(field, value, -100.0, 100.0); }
  void time(const char* field, double value) const { number(field, value, -1e9, 1e9); }
  void heading(double value) const { number("heading_rad", value, -1e3, 1e3); }

 private:
  const std::string& name_;
};

void check_one(const Gust& gust, const Checker& check) {
  check.place("origin_m", gust.origin_m);
  check.heading(gust.heading_rad);
  check.number("travel_m_per_s", gust.travel_m_per_s, 0.01, 100.0);
  check.speed("strength_m_per_s", gust.strength_m_per_s);
  check.length("width_m", gust.width_m);
  check.length("depth_m", gust.depth_m);
  check.length("way_m", gust.way_m);
  check.time("start_s", gust.start_s);
}

void check_one(const Tornado& tornado, const Checker& check) {
  check.place("origin_m", tornado.origin_m);
  check.heading(tornado.heading_rad);
  check.speed("travel_m_per_s", tornado.travel_m_per_s);
  check.speed("strength_m_per_s", tornado.strength_m_per_s);
  check.length("radius_m", tornado.radius_m);
  check.number("reach_m", tornado.reach_m, tornado.radius_m, 1e5);
  check.number("inflow", tornado.inflow, 0.0, 10.0);
  check.number("wander_m", tornado.wander_m, 0.0, 1e4);
  check.number("wander_s", tornado.wander_s, 0.1, 1e5);
  check.time("start_s", tornado.start_s);
  check.number("duration_s", tornado.duration_s, 0.0, 1e9);
}

void check_one(const Breeze& breeze, const Checker& check) {
  check.place("origin_m", breeze.origin_m);
  check.heading(breeze.heading_rad);
  check.speed("strength_m_per_s", breeze.strength_m_per_s);
  check.number("period_s", breeze.period_s, 0.1, 1e5);
  check.number("wavelength_m", breeze.wavelength_m, 0.1, 1e5);
  check.number("radius_m", breeze.radius_m, 0.0, 1e6);
}

}  // namespace

void check(const WindPrimitive& primitive, const std::string& name) {
  std::visit([&](const auto& one) { check_one(one, Checker(name)); }, primitive);
}

std::optional<BlowingPrimitive> blowing(const WindPrimitive& primitive, double time_s) {
  std::optional<Blowing> now = std::visit([&](const auto& one) { return at_time(one, time_s); }, primitive);
  if (now) {
    now->primitive = &primitive;
    now->time_s = time_s;
  }
  return now;
}

glm::vec2 velocity_m_per_s(const BlowingPrimitive& blowing, glm::dvec2 position_m) {
  return std::visit([&](const auto& one) { return velocity(one, blowing, position_m); }, *blowing.primitive);
}

glm::vec2 velocity_m_per_s(const WindPrimitive& primitive, glm::dvec2 position_m, double time_s) {
  const std::optional<BlowingPrimitive> now = blowing(primitive, time_s);
  return now ? velocity_m_per_s(*now, position_m) : glm::vec2(0.0f);
}

double end_s(const WindPrimitive& primitive) {
  if (const Gust* gust = std::get_if<Gust>(&primitive))
    return gust->start_s + gust->way_m / gust->travel_m_per_s;
  if (const Tornado* tornado = std::get_if<Tornado>(&primitive))
    return tornado->start_s + tornado->duration_s;
  return std::numeric_limits<double>::infinity();
}

}  // namespace prairie
