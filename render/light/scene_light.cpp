#include "render/light/scene_light.h"

#include <cmath>
#include <glm/trigonometric.hpp>

namespace prairie {
namespace {

// Clear afternoon sky, relative to a sky of intensity 1.
constexpr glm::vec3 kZenith(0.14f, 0.33f, 0.74f);
constexpr glm::vec3 kHorizon(0.74f, 0.82f, 0.90f);
// What reaches the top of a sward from the whole sky, and its foot through the leaves.
constexpr glm::vec3 kTopAmbient(0.50f, 0.60f, 0.72f);
constexpr glm::vec3 kRootAmbient(0.15f, 0.18f, 0.09f);
constexpr float kExposure = 0.78f;
constexpr float kSunHalo = 12.0f;
constexpr float kShadeDensityPerM2 = 1100.0f;

glm::vec3 sun_direction(const SunSpec& sun) {
  const double azimuth = glm::radians(sun.azimuth_deg);
  const double elevation = glm::radians(sun.elevation_deg);
  return glm::vec3(glm::dvec3(std::sin(azimuth) * std::cos(elevation),
                              std::cos(azimuth) * std::cos(elevation), std::sin(elevation)));
}

}  // namespace

LightParams scene_light(const SunSpec& sun) {
  const auto sky = static_cast<float>(sun.sky_intensity);
  LightParams light{};
  light.sun_direction = sun_direction(sun);
  light.haze_per_m = static_cast<float>(sun.haze_per_m);
  light.sun_radiance = sun.color * static_cast<float>(sun.intensity);
  light.sun_halo = kSunHalo;
  light.top_ambient = sky * kTopAmbient;
  light.exposure = kExposure;
  light.root_ambient = sky * kRootAmbient;
  light.shade_density_per_m2 = kShadeDensityPerM2;
  light.zenith_radiance = sky * kZenith;
  light.horizon_radiance = sky * kHorizon;
  return light;
}

}  // namespace prairie
