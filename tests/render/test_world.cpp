#include "tests/render/test_world.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <utility>

#include "maps/geotiff_output.h"
#include "tests/generator/test_meadow.h"

namespace prairie {
namespace {

constexpr double kMeadowM = 32.0;
constexpr double kDarkGroundM = 256.0;

SpeciesSpec grass(const char* name, float height_m, std::optional<MapSpec> density) {
  SpeciesSpec spec;
  spec.species = test_grass();
  spec.species.name = name;
  spec.species.params.height_m = height_m;
  spec.density = std::move(density);
  return spec;
}

MapSpec density_map(MapSpec map, double max_per_m2) {
  map.max = max_per_m2;
  return map;
}

}  // namespace

MapSpec write_map(const TemporaryFolder& folder, const char* name, double extent_m, double spacing_m,
                  const std::function<double(glm::dvec2)>& value) {
  const std::vector<std::byte> bytes =
      encode_geotiff(grid_from(square_frame(extent_m, spacing_m), value), nullptr);
  MapSpec map;
  map.file = folder.path() / name;
  map.field = name;
  map.spacing_m = spacing_m;
  std::ofstream(map.file, std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return map;
}

Scene meadow_scene(const TemporaryFolder& folder) {
  Scene scene;
  scene.folder = folder.path();
  scene.seed = 7;
  scene.height = write_map(folder, "ground.tif", kMeadowM, 2.0, [](glm::dvec2 p) {
    return 5.0 + 0.8 * std::sin(0.25 * p.x) + 0.5 * std::cos(0.2 * p.y + 0.1 * p.x);
  });
  const auto low = [](glm::dvec2 p) {
    const double to_bare_m = std::hypot(p.x - 24.0, p.y - 16.0);
    return std::clamp(0.5 * (to_bare_m - 3.0), 0.0, 1.0);
  };
  const auto tall = [](glm::dvec2 p) {
    return std::max(0.0, std::sin(0.35 * p.x + 0.6 * std::sin(0.3 * p.y)));
  };
  scene.species.push_back(
      grass("low", 0.25f, density_map(write_map(folder, "low.tif", kMeadowM, 1.0, low), 500.0)));
  scene.species.push_back(
      grass("tall", 0.6f, density_map(write_map(folder, "tall.tif", kMeadowM, 1.0, tall), 80.0)));
  scene.species.back().species.params.dry_share = 0.6f;
  return scene;
}

Scene dark_ground_scene(const TemporaryFolder& folder, bool repeats) {
  Scene scene;
  scene.folder = folder.path();
  scene.height = write_map(folder, "rough.tif", kDarkGroundM, 2.0, [](glm::dvec2 p) {
    return 4.0 * std::sin(0.0491 * p.x) * std::cos(0.0982 * p.y) +
           3.0 * unit_noise(3, std::lround(p.x), std::lround(p.y));
  });
  scene.height->repeats = repeats;
  scene.species.push_back(grass("none", 0.3f, std::nullopt));
  scene.species.back().uniform_density_per_m2 = 0.0;
  scene.soil_color = {0.0f, 0.0f, 0.0f};
  scene.sun.intensity = 0.0;
  scene.sun.sky_intensity = 100.0;
  scene.sun.haze_per_m = 0.0;
  return scene;
}

World open_world(Scene scene) {
  return World(std::move(scene), {});
}

Camera camera_above(const World& world, glm::dvec2 position_m, double above_m, double yaw_rad,
                    double pitch_rad) {
  Camera camera;
  camera.eye_m = {position_m, static_cast<double>(world.meadow().ground.height_m(position_m)) + above_m};
  camera.yaw_rad = yaw_rad;
  camera.pitch_rad = pitch_rad;
  camera.size_px = {160, 120};
  return camera;
}

}  // namespace prairie
