#include "app/viewer/wind_controls.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "animation/heading.h"
#include "world/bearing.h"
#include "world/scene_wind.h"

namespace prairie {
namespace {

constexpr float kSpeedStep = 1.0f;
constexpr float kHeadingStep = 15.0f;
constexpr float kTurbulenceStep = 0.25f;

float turned(float heading_deg, float by_deg) {
  const float heading = std::fmod(heading_deg + by_deg, 360.0f);
  return heading < 0.0f ? heading + 360.0f : heading;
}

}  // namespace

WindControls wind_controls_of(const Scene& scene, const Wind& wind) {
  WindControls controls;
  if (!scene.wind) return controls;
  const glm::dvec2 velocity = wind.mean.velocity_m_per_s(scene.wind->place_m, 0.0);
  const double speed = glm::length(velocity);
  const double bearing_deg =
      speed > 0.0 ? glm::degrees(std::atan2(velocity.x, velocity.y)) : scene.wind->heading_deg;
  controls.speed_m_per_s = std::min(static_cast<float>(speed), WindControls::kMostSpeedMPerS);
  controls.heading_deg = turned(static_cast<float>(bearing_deg), 0.0f);
  controls.turbulence = std::min(static_cast<float>(scene.wind->turbulence), WindControls::kMostTurbulence);
  return controls;
}

void apply_wind_key(int key, WindControls& controls) {
  const auto add = [](float& value, float by, float most) { value = std::clamp(value + by, 0.0f, most); };
  switch (key) {
    case GLFW_KEY_LEFT_BRACKET:
      add(controls.speed_m_per_s, -kSpeedStep, WindControls::kMostSpeedMPerS);
      break;
    case GLFW_KEY_RIGHT_BRACKET:
      add(controls.speed_m_per_s, kSpeedStep, WindControls::kMostSpeedMPerS);
      break;
    case GLFW_KEY_COMMA:
      controls.heading_deg = turned(controls.heading_deg, -kHeadingStep);
      break;
    case GLFW_KEY_PERIOD:
      controls.heading_deg = turned(controls.heading_deg, kHeadingStep);
      break;
    case GLFW_KEY_SEMICOLON:
      add(controls.turbulence, -kTurbulenceStep, WindControls::kMostTurbulence);
      break;
    case GLFW_KEY_APOSTROPHE:
      add(controls.turbulence, kTurbulenceStep, WindControls::kMostTurbulence);
      break;
    default:
      break;
  }
}

void blow(const WindControls& controls, World& world) {
  Motion& motion = world.motion();
  const auto speed = static_cast<double>(controls.speed_m_per_s);
  MeanWind mean(speed * direction_of(heading_rad_of(static_cast<double>(controls.heading_deg))));
  mean.follow(motion.wind().mean, world.time_s());
  motion.set_wind(mean, turbulence_of(world.scene(), static_cast<double>(controls.turbulence)));
}

}  // namespace prairie
