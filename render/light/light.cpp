#include "render/light/light.h"

#include <cmath>
#include <glm/geometric.hpp>
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

FrameParams frame_params(const World& world, const FramePlan& plan, const GroundLook& ground,
                         const FieldLook& field) {
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
  frame.mean_albedo = field.mean_albedo;
  frame.projected_from_above = static_cast<float>(field.projected_from_above);
  frame.density_per_leaf_area = static_cast<float>(field.density_per_leaf_area);
  frame.strip_height_m = static_cast<float>(field.height_m);
  frame.blade_width_m = static_cast<float>(field.blade_width_m);
  frame.lod_eye_m = glm::vec3(plan.lod_eye_m - camera.eye_m);
  frame.tile_m = static_cast<float>(meadow.tile_m);
  const glm::dvec2 eye_m(camera.eye_m);
  frame.eye_in_tile_m = glm::vec2(eye_m - meadow.tile_m * glm::floor(eye_m / meadow.tile_m));
  return frame;
}

}  // namespace prairie
