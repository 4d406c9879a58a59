#include "app/viewer/wind_controls.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "animation/heading.h"
#include "world/motion.h"
#include "world/scene/bearing.h"
#include "world/scene_wind.h"
#include "world/world.h"

namespace prairie {
namespace {

constexpr float kSpeedStepMPerS = 1.0f;
constexpr float kHeadingStepDeg = 15.0f;
constexpr float kTurbulenceStep = 0.25f;

float turned(float heading_deg, float by_deg) {
  const float heading = std::fmod(heading_deg + by_deg, 360.0f);
  return heading < 0.0f ? heading + 360.0f : heading;
}

}  // namespace

WindControls wind_controls_of(const Scene& scene, const Wind& wind) {
  WindControls controls;
  if (!scene.wind) return controls;
  const glm::dvec2 velocity = wind.mean.velocity_m_per_s(wind.mean.place_m(), 0.0);
  const double speed = glm::length(velocity);
  const double bearing_deg =
      speed > 0.0 ? glm::degrees(std::atan2(velocity.x, velocity.y)) : scene.wind->heading_deg;
  controls.speed_m_per_s = std::min(static_cast<float>(speed), WindControls::kMostSpeedMPerS);
  controls.heading_deg = turned(static_cast<float>(bearing_deg), 0.0f);
  controls.turbulence = std::min(static_cast<float>(scene.wind->turbulence), WindControls::kMostTurbulence);
  return controls;
}

void change_speed(WindControls& controls, int steps) {
  controls.speed_m_per_s = std::clamp(controls.speed_m_per_s + static_cast<float>(steps) * kSpeedStepMPerS,
                                      0.0f, WindControls::kMostSpeedMPerS);
}

void change_heading(WindControls& controls, int steps) {
  controls.heading_deg = turned(controls.heading_deg, static_cast<float>(steps) * kHeadingStepDeg);
}

void change_turbulence(WindControls& controls, int steps) {
  controls.turbulence = std::clamp(controls.turbulence + static_cast<float>(steps) * kTurbulenceStep, 0.0f,
                                   WindControls::kMostTurbulence);
}

void blow(const WindControls& controls, World& world) {
  Motion& motion = world.motion();
  const auto speed = static_cast<double>(controls.speed_m_per_s);
  MeanWind mean(speed * direction_of(heading_rad_of(static_cast<double>(controls.heading_deg))));
  mean.follow(motion.wind().mean, world.time_s());
  motion.set_wind(mean, turbulence_of(world.scene(), static_cast<double>(controls.turbulence)));
}

}  // namespace prairie
