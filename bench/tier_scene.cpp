#include "bench/tier_scene.h"

#include <fmt/format.h>

#include <cmath>

#include "generator/grasses.h"

namespace prairie {
namespace {

SpeciesParams plantain() {
  SpeciesParams params = fescue_params();
  params.root_color = {0.03f, 0.06f, 0.015f};
  params.tip_color = {0.09f, 0.2f, 0.04f};
  params.dry_share = 0.03f;
  params.height_m = 0.16f;
  params.width_m = 0.008f;
  params.curvature_rad = 1.1f;
  params.tilt_rad = 0.4f;
  params.stiffness = 100.0f;
  return params;
}

}  // namespace

std::vector<TierScene> tier_scenes(glm::dvec2 extent_m) {
  struct Kind {
    const char* name;
    SpeciesParams params;
    double densities_per_m2[3];
  };
  const Kind kinds[] = {{"fescue", fescue_params(), {300.0, 1000.0, 3000.0}},
                        {"oatgrass", oatgrass_params(), {100.0, 400.0, 1500.0}},
                        {"plantain", plantain(), {300.0, 1000.0, 3000.0}}};
  std::vector<TierScene> scenes;
  for (const Kind& kind : kinds) {
    for (const double density_per_m2 : kind.densities_per_m2) {
      for (const bool is_low_sun : {false, true}) {
        TierScene tier;
        tier.name = fmt::format("{} {} {}", kind.name, density_per_m2,
                                is_low_sun ? "low sun ahead" : "high sun behind");
        tier.is_middle = density_per_m2 == kind.densities_per_m2[1] && !is_low_sun;
        tier.scene.extent_m = extent_m;
        tier.scene.lod.blade_distance_m = 128.0;
        SpeciesSpec species;
        species.species = {kind.name, kind.params};
        species.uniform_density_per_m2 = density_per_m2;
        tier.scene.species.push_back(species);
        tier.scene.sun.azimuth_deg = is_low_sun ? 20.0 : 150.0;
        tier.scene.sun.elevation_deg = is_low_sun ? 15.0 : 45.0;
        scenes.push_back(tier);
      }
    }
  }
  return scenes;
}

Camera tier_camera(const TierScene& scene, double eye_height_m, glm::ivec2 size_px) {
  constexpr double kPixel = 0.0019245009;
  Camera camera;
  camera.eye_m = {0.5 * scene.scene.extent_m.x, 0.0, eye_height_m};
  camera.size_px = size_px;
  camera.fov_rad = 2.0 * std::atan(0.5 * size_px.y * kPixel);
  return camera;
}

int row_of_ground(const Camera& camera, double eye_height_m, double distance_m) {
  return static_cast<int>(
      std::lround(0.5 * camera.size_px.y + eye_height_m / (distance_m * camera.pixel_m())));
}

double mean_cover(const Picture& picture, const PixelRect& rect) {
  double sum = 0.0;
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x)
      sum += static_cast<double>(picture.cover[static_cast<std::size_t>(y) * picture.width + x]);
  }
  return sum / (rect.width * rect.height);
}

}  // namespace prairie
