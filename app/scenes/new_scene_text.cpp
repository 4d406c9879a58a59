#include "app/scenes/new_scene_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <numbers>

#include "app/terminal/usage_error.h"

namespace prairie {
namespace {

std::string head_text(const char* what, std::uint64_t seed) {
  return fmt::format(
      R"(# {}, made by `prairie new`.
# Metres and degrees; x east, y north, z up. Files are looked for in this folder. Colours are "#rrggbb" (sRGB) or
# [r, g, b] (linear). A mistyped key is refused, not ignored.
version = 1
seed = {}                # the same seed grows the same blades
tile_m = 4.0            # side of a tile, the unit of planting and of export
)",
      what, seed);
}

std::string camera_text(const CameraSpec& camera) {
  const std::string z =
      camera.z_above_ground ? fmt::format("\"+{}\"", camera.z_m) : fmt::format("{}", camera.z_m);
  // Adding zero turns a negative zero, which rounding leaves behind, into a plain one.
  return fmt::format("\n[[camera]]\nname = \"{}\"\nposition_m = [{}, {}, {}]\nyaw_deg = {}\npitch_deg = {}\n",
                     camera.name, camera.position_m.x + 0.0, camera.position_m.y + 0.0, z,
                     camera.yaw_deg + 0.0, camera.pitch_deg + 0.0);
}

constexpr const char* kCameraComment = R"(
# Cameras for --camera NAME. z as a text "+1.7" is above the ground; yaw 0 looks north, clockwise; pitch up is positive.)";

std::string light_text(double sun_azimuth_deg, double sun_elevation_deg) {
  return fmt::format(R"(
[sun]
azimuth_deg = {}       # clockwise from north
elevation_deg = {}
color = [1.0, 0.93, 0.80]
intensity = 3.2

[sky]
intensity = 1.0
haze_per_m = 0.0006     # how fast things fade with distance

[lod]
quality = "medium"      # low, medium or high: how early blades thin out with distance
blade_distance_m = 120.0  # beyond it only the ground's colour tells of grass
)",
                     sun_azimuth_deg, sun_elevation_deg);
}

constexpr const char* kFescueParameters = R"(height_m = 0.32         # length of a blade
height_spread = 0.35    # blades lie in mean * (1 - spread) ... mean * (1 + spread)
width_mm = 3.5
tilt_deg = 12.0         # largest angle of a blade's foot to the ground's normal
curvature_deg = 45.0    # turning from foot to tip
clump_m = 0.28          # distance between tufts
clump_strength = 0.55   # 0: every blade for itself; 1: blades of a tuft are alike
)";

std::string range_text(const std::optional<std::array<double, 2>>& range) {
  return range ? fmt::format(", range = [{}, {}]", (*range)[0], (*range)[1]) : std::string();
}

std::string raster_height_text(const NewSceneRequest& request, const std::string& name) {
  std::string text = fmt::format("\n[height]\nfile = \"{}\"\n", name);
  if (request.height_spacing_m) text += fmt::format("spacing_m = {}\n", *request.height_spacing_m);
  if (request.height_range_m) {
    text += fmt::format("range = [{}, {}]       # heights of 0 and of the type's largest value\n",
                        (*request.height_range_m)[0], (*request.height_range_m)[1]);
  }
  return text + "# repeat = true         # endless ground\n";
}

std::string raster_density_text(const NewSceneRequest& request, const std::string& name) {
  if (!request.density) return "density = 1000.0        # blades per m², everywhere\n";
  const DensityRequest& density = *request.density;
  // Level ground has no other map that says how large a pixel is.
  const bool gives_spacing = !request.height_file && request.height_spacing_m;
  return fmt::format(
      "# blades per m² = max_per_m2 * clamp((value - lo) / (hi - lo), 0, 1) ^ curve, with range = [lo, hi]\n"
      "density = {{ file = \"{}\"{}{}, curve = {}, max_per_m2 = {} }}\n",
      name, gives_spacing ? fmt::format(", spacing_m = {}", *request.height_spacing_m) : std::string(),
      range_text(density.range), density.curve, density.max_per_m2);
}

}  // namespace

std::string example_scene_text(std::uint64_t seed, const ExampleMeadow& meadow) {
  std::string text = head_text("A meadow in a shallow valley, with a path and a clearing", seed);
  text += fmt::format(R"(
[height]
file = "{}"     # any image that OpenImageIO reads; its first row is north
# spacing_m = 2.0       # needed only where the file has no geo-reference
# range = [0.0, 50.0]   # heights of 0 and of the largest value, for files of whole numbers
# repeat = true         # endless ground

[ground]
soil_color = "#5d5040"

# One [[species]] for each grass, up to 16. A density is a number (blades per m², everywhere) or a map:
# max_per_m2 * clamp((value - lo) / (hi - lo), 0, 1) ^ curve, with range = [lo, hi].
[[species]]
name = "fescue"
density = {{ file = "{}", spacing_m = {}, max_per_m2 = {} }}
)",
                      kExampleGroundFile, kExampleFescueFile, meadow.fescue_per_m2.spacing_m,
                      meadow.fescue_per_m2.max);
  text += kFescueParameters;
  text += fmt::format(R"(
[[species]]
name = "oatgrass"
density = {{ file = "{}", spacing_m = {}, max_per_m2 = {} }}
height_m = 0.72
height_spread = 0.25
width_mm = 3.0
width_spread = 0.25
tilt_deg = 9.0
lean_deg = 14.0         # how far a tuft combs its blades to one side
curvature_deg = 34.0
mass_g = 0.12
stiffness = 40.0
clump_m = 0.45
clump_strength = 0.65
clump_spray_deg = 12.0
root_color = "#4d5526"
tip_color = "#b59a55"
dry_color = "#d8bf82"
transmission = [0.66, 0.56, 0.22]  # colour of the light that crosses a blade
dry_share = 0.45        # 0: all green; 1: all straw
dry_spread = 0.35
hue_spread = 0.35

# Factors on what the species say, from maps: blade_height, bend, color.
[maps]
blade_height = {{ file = "{}", spacing_m = {}, max = {} }}
)",
                      kExampleOatgrassFile, meadow.oatgrass_per_m2.spacing_m, meadow.oatgrass_per_m2.max,
                      kExampleBladeHeightFile, meadow.blade_height.spacing_m, meadow.blade_height.max);
  text += kCameraComment;
  for (const CameraSpec& camera : meadow.cameras) text += camera_text(camera);
  // From the side and a little ahead of the default camera: blades light up where the sun shines through
  // them.
  text += light_text(285.0, 34.0);
  return text;
}

std::string raster_scene_text(const NewSceneRequest& request, const RasterNames& names,
                              const std::optional<CameraSpec>& camera) {
  std::string text = head_text("A scene from your own rasters", request.seed);
  if (request.height_file) text += raster_height_text(request, names.height);
  text += "\n[[species]]\nname = \"fescue\"\n";
  text += raster_density_text(request, names.density);
  text += kFescueParameters;
  text += kCameraComment;
  if (camera) text += camera_text(*camera);
  text += light_text(150.0, 38.0);
  return text;
}

std::string walkers_text(std::uint32_t count, const CameraSpec& camera, glm::dvec2 extent_m) {
  if (count == 0) return {};
  constexpr double kPerM2 = 0.04, kMostPerM2 = 0.8, kLeastRadiusM = 6.0, kFromBorderM = 1.0;
  const double most_radius_m = 0.5 * std::min(extent_m.x, extent_m.y) - kFromBorderM;
  const double radius_m =
      std::floor(10.0 * std::min(std::max(std::sqrt(count / (kPerM2 * std::numbers::pi)), kLeastRadiusM),
                                 most_radius_m)) /
      10.0;
  if (!(count < kMostPerM2 * std::numbers::pi * radius_m * radius_m))
    throw UsageError("--walkers", fmt::format("{}", count),
                     fmt::format("fewer on {} × {} m", extent_m.x, extent_m.y));
  const double yaw_rad = camera.yaw_deg * std::numbers::pi / 180.0;
  const glm::dvec2 ahead_m =
      camera.position_m + (radius_m + 4.0) * glm::dvec2(std::sin(yaw_rad), std::cos(yaw_rad));
  const glm::dvec2 nearest_m(radius_m + kFromBorderM), farthest_m = extent_m - nearest_m;
  const glm::dvec2 centre_m =
      glm::floor(10.0 * glm::clamp(ahead_m, nearest_m, glm::max(farthest_m, nearest_m))) / 10.0;
  return fmt::format(R"(
# Who walks here; `prairie walk` shows them. Behaviours: wander, stroll (about where they start), visit and go (to [[goal]]s).
[[walkers]]
name = "people"
count = {}
position_m = [{}, {}]   # they start strewn over a disc
radius_m = {}
behaviour = "wander"

# Keeps them on the ground.
[[wall]]
outline_m = [[0, 0], [{}, 0], [{}, {}], [0, {}]]
)",
                     count, centre_m.x, centre_m.y, radius_m, extent_m.x, extent_m.x, extent_m.y, extent_m.y);
}

}  // namespace prairie
