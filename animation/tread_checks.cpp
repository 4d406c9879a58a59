#include "animation/tread_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "animation/range_check.h"
#include "files/error.h"

namespace prairie {
namespace {

constexpr double kLongestStepM = 100.0;

// Not so written as to let NaN pass.
bool within(double value, double low, double high) {
  return value >= low && value <= high;
}

// Names only where they are needed: there may be millions of numbers.
template <class Number>
void check(const char* field, Number number, double low, double high, const char* what) {
  const auto value = static_cast<double>(number);
  if (!within(value, low, high)) check_range(field, value, low, high, what);
}

// Bodies reach a little beyond where they may be.
void check_page(PageIndex page, double spacing_m) {
  const double most = (kFarthestM + 100.0) / (kPageNodes * spacing_m);
  check("treads.page", page.i, -most, most, "a page");
  check("treads.page", page.j, -most, most, "a page");
}

std::string name_of(const TreadStep& step, const char* field) {
  return fmt::format("body {}: {}", step.id, field);
}

}  // namespace

const TreadSettings& checked(const TreadSettings& settings) {
  const auto number = [](const char* name, auto value, double low, double high) {
    check((std::string("treading.") + name).c_str(), value, low, high, "a number");
  };
  number("spacing_m", settings.spacing_m, 0.05, 0.5);
  number("reach_radii", settings.reach_radii, 1.0, 6.0);
  number("field_scale", settings.field_scale, 0.01, 10.0);
  number("most_tilt_rad", settings.most_tilt_rad, 0.1, 1.5707);
  number("recovery_s", settings.recovery_s, 0.1, static_cast<double>(kMostRecoveryS));
  number("load_slowing", settings.load_slowing, 0.0, 100.0);
  number("worn_slowing", settings.worn_slowing, 0.0, 100.0);
  number("wear_passes", settings.wear_passes, 1.0, 1e9);
  // A pass adds more than it wears, so that grass never falls below its worn state.
  number("worn_field", settings.worn_field, 0.0, 2.0);
  return settings;
}

void check_time(double from_s, double to_s) {
  if (std::isfinite(to_s) && to_s >= from_s) return;
  throw BadInput("", "time_s", fmt::format("{}", to_s),
                 fmt::format("{} or later: time does not go backwards", from_s));
}

void check_steps(std::span<const TreadStep> steps, std::span<const std::uint32_t> order) {
  const TreadStep* previous = nullptr;
  for (const std::uint32_t n : order) {
    const TreadStep& step = steps[n];
    if (previous != nullptr && previous->id == step.id) {
      throw BadInput("", name_of(step, "id"), "it twice", "one step of each body at a time");
    }
    const auto number = [&](const char* field, double value, double low, double high, const char* what) {
      // Names only where they are needed: this runs for every body in every step.
      if (!within(value, low, high)) check_range(name_of(step, field), value, low, high, what);
    };
    for (const double coordinate_m : {step.from_m.x, step.from_m.y, step.to_m.x, step.to_m.y}) {
      number("position_m", coordinate_m, -kFarthestM, kFarthestM, "metres");
    }
    number("step_m", std::hypot(step.to_m.x - step.from_m.x, step.to_m.y - step.from_m.y), 0.0, kLongestStepM,
           "metres");
    number("radius_m", step.radius_m, 0.01, 5.0, "metres");
    number("weight", step.weight, 0.0, 1000.0, "a number");
    previous = &step;
  }
}

void check_state(const TreadSettings& settings, const TreadState& state) {
  check("treads.time_s", state.time_s, 0.0, 1e12, "seconds");
  for (const double spacing_m : {state.nodes.spacing_m(), state.wear.spacing_m()}) {
    check("treads.spacing_m", spacing_m, settings.spacing_m, settings.spacing_m, "the scene's");
  }
  for (const auto& [page, nodes] : state.nodes.pages()) {
    check_page(page, settings.spacing_m);
    for (const TreadNode& node : nodes) {
      check("treads.field", node.field, 0.0, 1e9, "a number");
      check("treads.start_s", node.start_s, -1e12, state.time_s, "seconds");
      const double least_s = node.field > 0.0f ? 1e-3 : 0.0;
      check("treads.recovery_s", node.recovery_s, least_s, 1e12, "seconds");
      check("treads.blades_recovery_s", node.blades_recovery_s, 0.0, static_cast<double>(kMostRecoveryS),
            "seconds");
      check("treads.direction", std::hypot(node.direction.x, node.direction.y), 0.0, 1.5, "a length");
    }
  }
  for (const auto& [page, wear] : state.wear.pages()) {
    check_page(page, settings.spacing_m);
    check_wear(wear);
  }
}

void check_wear(std::span<const float> wear) {
  for (const float value : wear) check("wear", value, 0.0, 1.0, "a share");
}

}  // namespace prairie
