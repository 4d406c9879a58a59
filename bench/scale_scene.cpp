#include "bench/scale_scene.h"

#include <fmt/format.h>

#include <glm/trigonometric.hpp>
#include <string>

#include "world/camera_placement.h"

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

// The grasses of `prairie new`'s meadow.
constexpr const char* kSceneText = R"(version = 1
[height]
file = "{}"
repeat = {}
[ground]
soil_color = "#5d5040"
[[species]]
name = "fescue"
density = {}
height_m = 0.32
height_spread = 0.35
width_mm = 3.5
tilt_deg = 12.0
curvature_deg = 45.0
clump_m = 0.28
clump_strength = 0.55
[[species]]
name = "oatgrass"
density = {}
height_m = 0.72
height_spread = 0.25
width_mm = 3.0
width_spread = 0.25
tilt_deg = 9.0
lean_deg = 14.0
curvature_deg = 34.0
mass_g = 0.12
stiffness = 40.0
clump_m = 0.45
clump_strength = 0.65
clump_spray_deg = 12.0
root_color = "#4d5526"
tip_color = "#b59a55"
dry_color = "#d8bf82"
transmission = [0.66, 0.56, 0.22]
dry_share = 0.45
dry_spread = 0.35
hue_spread = 0.35
[sun]
azimuth_deg = 285.0
elevation_deg = 34.0
[lod]
quality = "medium"
blade_distance_m = 128.0
)";

constexpr const char* kWindText = R"([wind]
speed_m_per_s = 6.0
heading_deg = 70
[[wind.gust]]
position_m = [700, 580]
heading_deg = 70
)";

// 60 m before the start of the walk.
constexpr const char* kWalkersText = R"([[walkers]]
name = "people"
count = {}
position_m = [720, 612]
radius_m = 32
)";

}  // namespace

World scale_world(const ScaleGround& ground, const ScaleVariant& variant) {
  std::string text =
      fmt::format(fmt::runtime(kSceneText), ground.file.filename().string(), variant.repeats,
                  kFescuePerM2 * variant.density_factor, kOatgrassPerM2 * variant.density_factor);
  if (variant.windy) text += kWindText;
  if (variant.walkers > 0) text += fmt::format(fmt::runtime(kWalkersText), variant.walkers);
  return World(parse_scene(text, ground.file.parent_path(), {}), {});
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
