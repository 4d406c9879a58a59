#include "bench/scale_scene.h"

#include <glm/trigonometric.hpp>
#include <utility>
#include <vector>

#include "generator/grasses.h"
#include "world/camera_placement.h"
#include "world/scene/bearing.h"
#include "world/scene/color_text.h"

namespace prairie {
namespace {

constexpr double kFescuePerM2 = 800.0;
constexpr double kOatgrassPerM2 = 200.0;
// On either ground a slope with near and far grass in one view, and little enough of the field before the eye
// that every blade of it can be drawn for comparison.
constexpr glm::dvec2 kStartM{750.0, 560.0};
constexpr double kYawDeg = 330.0;
constexpr double kPitchDeg = -2.0;
constexpr double kWalkMPerS = 1.4;

/// The grasses of `prairie new`'s meadow.
std::vector<SpeciesSpec> grasses(double density_factor) {
  SpeciesSpec fescue;
  fescue.species = {"fescue", fescue_params()};
  fescue.uniform_density_per_m2 = kFescuePerM2 * density_factor;
  SpeciesSpec oatgrass;
  oatgrass.species = {"oatgrass", oatgrass_params()};
  oatgrass.uniform_density_per_m2 = kOatgrassPerM2 * density_factor;
  return {fescue, oatgrass};
}

WindSpec wind_with_a_gust() {
  WindSpec wind;
  wind.speed_m_per_s = 6.0;
  wind.heading_deg = 70.0;
  Gust gust;
  gust.origin_m = {700.0, 580.0};
  gust.heading_rad = heading_rad_of(70.0);
  wind.primitives = {gust};
  return wind;
}

/// 60 m before the start of the walk.
WalkerGroup people(std::uint32_t count) {
  WalkerGroup group;
  group.name = "people";
  group.count = count;
  group.centre_m = {720.0, 612.0};
  group.radius_m = 32.0;
  return group;
}

}  // namespace

World scale_world(const ScaleGround& ground, const ScaleVariant& variant) {
  Scene scene;
  scene.folder = ground.file.parent_path();
  scene.height = MapSpec{};
  scene.height->file = ground.file;
  scene.height->field = "height.file";
  scene.height->repeats = variant.repeats;
  scene.soil_color = *linear_from_hex("#5d5040");
  scene.species = grasses(variant.density_factor);
  scene.sun.azimuth_deg = 285.0;
  scene.sun.elevation_deg = 34.0;
  scene.lod.blade_distance_m = 128.0;
  if (variant.windy) scene.wind = wind_with_a_gust();
  if (variant.walkers > 0) scene.walkers = {people(static_cast<std::uint32_t>(variant.walkers))};
  return World(std::move(scene), {});
}

double expected_blades(const World& world) {
  double per_m2 = 0.0;
  for (const PlantedSpecies& planted : world.meadow().species) {
    per_m2 += static_cast<double>(planted.density_per_m2.sample({0.0, 0.0}));
  }
  return per_m2 * world.meadow().extent_m.x * world.meadow().extent_m.y;
}

Camera walk_camera(const World& world, int frame) {
  Camera camera;
  camera.yaw_rad = glm::radians(kYawDeg);
  const glm::dvec2 ahead(camera.forward());
  const glm::dvec2 place_m = kStartM + ahead * (kWalkMPerS * kWalkFrameS * frame);
  camera.eye_m =
      glm::dvec3(place_m, static_cast<double>(world.meadow().ground.height_m(place_m)) + kEyeHeightM);
  camera.pitch_rad = glm::radians(kPitchDeg);
  return camera;
}

}  // namespace prairie
