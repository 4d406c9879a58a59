#include "render/light.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "shaders/kernels/kernels.h"

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

// Mean over the parts of a dense sward that are seen from afar: the upper two thirds of blades that turn
// every way.
glm::vec3 flat_response(const FrameParams& frame, glm::vec3 transmission) {
  constexpr int kTurns = 12;
  constexpr int kHeights = 8;
  Kernels kernels;
  glm::vec3 sum(0.0f);
  for (int turn = 0; turn < kTurns; ++turn) {
    const float azimuth = 6.2831853f * (static_cast<float>(turn) + 0.5f) / kTurns;
    const glm::vec3 normal(0.87f * std::cos(azimuth), 0.87f * std::sin(azimuth), 0.5f);
    const float n_dot_l = glm::dot(normal, frame.sun_direction);
    for (int part = 0; part < kHeights; ++part) {
      const float l = 0.33f + 0.67f * (static_cast<float>(part) + 0.5f) / kHeights;
      sum += kernels.blade_radiance(frame, glm::vec3(1.0f), transmission, 0.0f, l, 0.8f, n_dot_l, 1.0f);
    }
  }
  return sum / static_cast<float>(kTurns * kHeights);
}

}  // namespace

FrameParams frame_params(const World& world, const FramePlan& plan, const GroundLook& ground) {
  const Camera& camera = plan.camera;
  const SunSpec& sun = world.scene().sun;
  const Meadow& meadow = world.meadow();
  const auto sky = static_cast<float>(sun.sky_intensity);
  FrameParams frame{};
  frame.clip_from_eye = camera.clip_from_eye();
  frame.towards_eye = glm::vec3(-camera.forward());
  frame.parallel = camera.is_orthographic() ? 1.0f : 0.0f;
  frame.sun_direction = sun_direction(sun);
  frame.pixel_m = static_cast<float>(camera.pixel_m());
  frame.sun_radiance = sun.color * static_cast<float>(sun.intensity);
  frame.haze_per_m = static_cast<float>(sun.haze_per_m);
  frame.top_ambient = sky * kTopAmbient;
  frame.exposure = kExposure;
  frame.root_ambient = sky * kRootAmbient;
  frame.shade_density_per_m2 = kShadeDensityPerM2;
  frame.zenith_radiance = sky * kZenith;
  frame.sun_halo = kSunHalo;
  frame.horizon_radiance = sky * kHorizon;
  frame.flat_period_x_m = static_cast<float>(ground.flat_period_m.x);
  frame.flat_period_y_m = static_cast<float>(ground.flat_period_m.y);
  frame.ground_from_eye_m = glm::vec3(ground.anchor_m - camera.eye_m);
  frame.soil_color = meadow.soil_color;
  frame.anchor_m = glm::vec2(ground.anchor_m);
  frame.lod = plan.lod;
  frame.flat_response = flat_response(frame, ground.mean_transmission);
  return frame;
}

}  // namespace prairie
