#include "app/scenes/new_scene_contents.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "app/terminal/usage_error.h"
#include "generator/grasses.h"
#include "world/scene/color_text.h"

namespace prairie {
namespace {

MapSpec map_of(const Scene& scene, const std::string& file, const char* field) {
  MapSpec map;
  map.file = scene.folder / file;
  map.field = field;
  return map;
}

MapSpec map_of(const Scene& scene, const std::string& file, const char* field, const GreyMap& values) {
  MapSpec map = map_of(scene, file, field);
  map.spacing_m = values.spacing_m;
  map.max = values.max;
  return map;
}

SpeciesSpec species_of(const char* name, const SpeciesParams& params) {
  SpeciesSpec species;
  species.species = {name, params};
  return species;
}

Scene scene_in(const NewSceneRequest& request) {
  Scene scene;
  scene.folder = request.folder;
  scene.seed = request.seed;
  return scene;
}

}  // namespace

Scene example_scene(const NewSceneRequest& request, const ExampleMeadow& meadow) {
  Scene scene = scene_in(request);
  scene.height = map_of(scene, kExampleGroundFile, "height.file");
  scene.soil_color = *linear_from_hex("#5d5040");
  SpeciesSpec fescue = species_of("fescue", fescue_params());
  fescue.density = map_of(scene, kExampleFescueFile, "species.0.density.file", meadow.fescue_per_m2);
  SpeciesSpec oatgrass = species_of("oatgrass", oatgrass_params());
  oatgrass.density = map_of(scene, kExampleOatgrassFile, "species.1.density.file", meadow.oatgrass_per_m2);
  scene.species = {fescue, oatgrass};
  scene.blade_height = map_of(scene, kExampleBladeHeightFile, "maps.blade_height.file", meadow.blade_height);
  scene.cameras = meadow.cameras;
  // From the side and a little ahead of the default camera: blades light up where the sun shines through
  // them.
  scene.sun.azimuth_deg = 285.0;
  scene.sun.elevation_deg = 34.0;
  return scene;
}

Scene raster_scene(const NewSceneRequest& request, const RasterNames& names) {
  Scene scene = scene_in(request);
  if (!names.heights.empty()) {
    scene.height = map_of(scene, names.heights.front(), "height.file");
    for (std::size_t k = 1; k < names.heights.size(); ++k)
      scene.height->more_files.push_back(scene.folder / names.heights[k]);
    scene.height->spacing_m = request.height_spacing_m;
    scene.height->range = request.height_range_m;
    scene.height->scale = request.height_scale;
    scene.height->nodata = request.height_nodata;
    scene.height->size_px = request.height_size_px;
    scene.height->crs = request.height_crs;
  }
  SpeciesSpec fescue = species_of("fescue", fescue_params());
  if (request.density) {
    fescue.density = map_of(scene, names.density, "species.0.density.file");
    fescue.density->channel = request.density->channel;
    fescue.density->range = request.density->range;
    fescue.density->nodata = request.density->nodata;
    fescue.density->curve = request.density->curve;
    fescue.density->max = request.density->max_per_m2;
    fescue.density->spacing_m = request.density->spacing_m;
  }
  scene.species = {fescue};
  return scene;
}

void add_walkers(Scene& scene, std::uint32_t count, glm::dvec2 extent_m) {
  if (count == 0) return;
  constexpr double kPerM2 = 0.04, kMostPerM2 = 0.8, kLeastRadiusM = 6.0, kFromBorderM = 1.0;
  const double most_radius_m = 0.5 * std::min(extent_m.x, extent_m.y) - kFromBorderM;
  const double radius_m =
      std::floor(10.0 * std::min(std::max(std::sqrt(count / (kPerM2 * std::numbers::pi)), kLeastRadiusM),
                                 most_radius_m)) /
      10.0;
  if (!(count < kMostPerM2 * std::numbers::pi * radius_m * radius_m))
    throw UsageError("--walkers", fmt::format("{}", count),
                     fmt::format("fewer on {} × {} m", extent_m.x, extent_m.y));
  const CameraSpec& camera = scene.cameras.front();
  const double yaw_rad = glm::radians(camera.yaw_deg);
  const glm::dvec2 ahead_m =
      camera.position_m + (radius_m + 4.0) * glm::dvec2(std::sin(yaw_rad), std::cos(yaw_rad));
  const glm::dvec2 nearest_m(radius_m + kFromBorderM), farthest_m = extent_m - nearest_m;
  WalkerGroup people;
  people.name = "people";
  people.count = count;
  people.centre_m = glm::floor(10.0 * glm::clamp(ahead_m, nearest_m, glm::max(farthest_m, nearest_m))) / 10.0;
  people.radius_m = radius_m;
  scene.walkers.push_back(people);
  Wall wall;
  wall.outline.outer_m = {{0.0, 0.0}, {extent_m.x, 0.0}, extent_m, {0.0, extent_m.y}};
  scene.standing.walls.push_back(wall);
}

}  // namespace prairie
