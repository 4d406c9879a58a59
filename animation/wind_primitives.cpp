#include "animation/wind_primitives.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

#include "animation/heading.h"
#include "maps/error.h"
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

// Where a gust is along its way, and how strong it still is.
struct Front {
  double at_m;
  float strength;
};

std::optional<Front> front_of(const Gust& gust, double time_s) {
  const double at_m = gust.travel_m_per_s * (time_s - gust.start_s);
  if (at_m <= 0.0 || at_m >= gust.way_m) return std::nullopt;
  const double fade_m = std::min(gust.depth_m, 0.5 * gust.way_m);
  return Front{at_m, ramp(at_m / fade_m) * ramp((gust.way_m - at_m) / fade_m)};
}

glm::vec2 velocity(const Gust& gust, glm::dvec2 position_m, double time_s) {
  const std::optional<Front> front = front_of(gust, time_s);
  if (!front) return glm::vec2(0.0f);
  const glm::dvec2 forward = direction_of(gust.heading_rad);
  const glm::dvec2 from_m = position_m - gust.origin_m;
  const double behind = (front->at_m - glm::dot(from_m, forward)) / gust.depth_m;
  const double across_m = std::abs(forward.x * from_m.y - forward.y * from_m.x);
  if (behind <= 0.0 || behind >= 1.0 || across_m >= 0.5 * gust.width_m) return glm::vec2(0.0f);
  const float along = ramp(behind / kRise) * (1.0f - ramp((behind - kRise) / (1.0 - kRise)));
  const float mask = along * inside(across_m, 0.5 * gust.width_m) * front->strength;
  return glm::vec2(forward * gust.strength_m_per_s) * mask;
}

std::optional<Covered> covered_by(const Gust& gust, double time_s) {
  const std::optional<Front> front = front_of(gust, time_s);
  if (!front) return std::nullopt;
  const glm::dvec2 forward = direction_of(gust.heading_rad);
  const glm::dvec2 tip_m = gust.origin_m + front->at_m * forward, tail_m = tip_m - gust.depth_m * forward;
  const glm::dvec2 side_m = 0.5 * gust.width_m * glm::abs(glm::dvec2(forward.y, forward.x));
  return Covered{glm::min(tip_m, tail_m) - side_m, glm::max(tip_m, tail_m) + side_m};
}

glm::dvec2 eye_of(const Tornado& tornado, double time_s) {
  const double age_s = time_s - tornado.start_s;
  const double phase = static_cast<double>(Kernels{}.unit_from_u32(Kernels{}.hash_u32(tornado.seed)));
  const double turns = age_s / tornado.wander_s;
  const glm::dvec2 wander(sine_of_turns(turns + phase), sine_of_turns(turns / kGolden + kGolden * phase));
  return tornado.origin_m + tornado.travel_m_per_s * age_s * direction_of(tornado.heading_rad) +
         tornado.wander_m * wander;
}

bool blows(const Tornado& tornado, double time_s) {
  return time_s > tornado.start_s && time_s < tornado.start_s + tornado.duration_s;
}

glm::vec2 velocity(const Tornado& tornado, glm::dvec2 position_m, double time_s) {
  if (!blows(tornado, time_s)) return glm::vec2(0.0f);
  const glm::dvec2 from_m = position_m - eye_of(tornado, time_s);
  const double r_m = glm::length(from_m);
  if (r_m >= tornado.reach_m) return glm::vec2(0.0f);
  const double come_up_s = std::min(kComeUpS, 0.5 * tornado.duration_s);
  const float age = ramp((time_s - tornado.start_s) / come_up_s) *
                    ramp((tornado.start_s + tornado.duration_s - time_s) / come_up_s);
  const double q2 = glm::dot(from_m, from_m) / (tornado.radius_m * tornado.radius_m);
  // Speed by distance from the eye, where the direction is undefined and the speed is 0.
  const double turning_per_s = 2.0 * tornado.strength_m_per_s / (tornado.radius_m * (1.0 + q2));
  const double inflow_per_s = tornado.inflow * std::abs(turning_per_s);
  const glm::dvec2 v(-from_m.y * turning_per_s - from_m.x * inflow_per_s,
                     from_m.x * turning_per_s - from_m.y * inflow_per_s);
  return glm::vec2(v) * (age * inside(r_m, tornado.reach_m));
}

std::optional<Covered> covered_by(const Tornado& tornado, double time_s) {
  if (!blows(tornado, time_s)) return std::nullopt;
  const glm::dvec2 eye_m = eye_of(tornado, time_s);
  return Covered{eye_m - tornado.reach_m, eye_m + tornado.reach_m};
}

glm::vec2 velocity(const Breeze& breeze, glm::dvec2 position_m, double time_s) {
  const glm::dvec2 forward = direction_of(breeze.heading_rad);
  const glm::dvec2 from_m = position_m - breeze.origin_m;
  const double turns = time_s / breeze.period_s - glm::dot(from_m, forward) / breeze.wavelength_m;
  float strength = static_cast<float>(breeze.strength_m_per_s * (0.5 + 0.5 * sine_of_turns(turns)));
  if (breeze.radius_m > 0.0) strength *= inside(glm::length(from_m), breeze.radius_m);
  return glm::vec2(forward) * strength;
}

std::optional<Covered> covered_by(const Breeze& breeze, double) {
  constexpr double kEverywhere = 1e300;
  if (breeze.radius_m == 0.0) return Covered{glm::dvec2(-kEverywhere), glm::dvec2(kEverywhere)};
  return Covered{breeze.origin_m - breeze.radius_m, breeze.origin_m + breeze.radius_m};
}

/// Checks a primitive's numbers one by one.
class Checker {
 public:
  explicit Checker(const std::string& name) : name_(name) {}

  void number(const char* field, double value, double low, double high) const {
    if (value >= low && value <= high) return;
    throw BadInput("", name_ + ": " + field, fmt::format("{}", value), fmt::format("{} to {}", low, high));
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

glm::vec2 velocity_m_per_s(const WindPrimitive& primitive, glm::dvec2 position_m, double time_s) {
  return std::visit([&](const auto& one) { return velocity(one, position_m, time_s); }, primitive);
}

std::optional<Covered> covered(const WindPrimitive& primitive, double time_s) {
  return std::visit([&](const auto& one) { return covered_by(one, time_s); }, primitive);
}

double end_s(const WindPrimitive& primitive) {
  if (const Gust* gust = std::get_if<Gust>(&primitive))
    return gust->start_s + gust->way_m / gust->travel_m_per_s;
  if (const Tornado* tornado = std::get_if<Tornado>(&primitive))
    return tornado->start_s + tornado->duration_s;
  return std::numeric_limits<double>::infinity();
}

}  // namespace prairie
