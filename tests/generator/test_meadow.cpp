#include "tests/generator/test_meadow.h"

#include <cmath>
#include <utility>

#include "generator/cell_seed.h"

namespace prairie {

Species test_grass() {
  Species grass;
  grass.name = "test grass";
  SpeciesParams& p = grass.params;
  p.root_color = {0.03f, 0.08f, 0.01f};
  p.tip_color = {0.12f, 0.25f, 0.04f};
  p.dry_color = {0.45f, 0.36f, 0.16f};
  p.dry_share = 0.2f;
  p.dry_spread = 0.3f;
  p.hue_spread = 0.4f;
  p.transmission = {0.5f, 0.6f, 0.1f};
  p.specular = 0.1f;
  p.height_m = 0.3f;
  p.height_spread = 0.4f;
  p.width_m = 0.004f;
  p.width_spread = 0.3f;
  p.tilt_rad = 0.4f;
  p.lean_rad = 0.5f;
  p.curvature_rad = 0.9f;
  p.curvature_spread = 0.5f;
  p.mass_g = 0.05f;
  p.stiffness = 4.0f;
  p.stiffness_spread = 0.3f;
  p.clump_m = 0.25f;
  p.clump_strength = 0.7f;
  p.clump_spray_rad = 0.3f;
  return grass;
}

NodeGrid grid_from(const GridFrame& frame, const std::function<double(glm::dvec2)>& value) {
  std::vector<float> values;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      values.push_back(static_cast<float>(value(frame.origin_m + frame.spacing_m * glm::dvec2(column, row))));
    }
  }
  return NodeGrid(frame, 1, std::move(values));
}

GridFrame square_frame(double extent_m, double spacing_m) {
  const int nodes = static_cast<int>(std::lround(extent_m / spacing_m)) + 1;
  return {nodes, nodes, spacing_m, {0.0, 0.0}, false};
}

double unit_noise(std::uint64_t seed, std::int64_t x, std::int64_t y) {
  const auto place = static_cast<std::uint64_t>(x) * 0x9e3779b97f4a7c15ull + static_cast<std::uint64_t>(y);
  return unit_from_bits(mix_bits(mix_bits(seed) ^ place));
}

Meadow level_meadow(double extent_m, NodeGrid density_per_m2) {
  Meadow meadow;
  meadow.extent_m = glm::dvec2(extent_m);
  meadow.species.push_back({test_grass(), std::move(density_per_m2)});
  return meadow;
}

NodeGrid uniform_density(double per_m2) {
  return NodeGrid::uniform(static_cast<float>(per_m2));
}

NodeGrid smooth_density(double extent_m, double mean_per_m2) {
  return grid_from(square_frame(extent_m, 4.0), [&](glm::dvec2 p) {
    return mean_per_m2 * (1.0 + 0.4 * std::sin(0.314 * p.x + 0.5) + 0.2 * std::cos(0.314 * p.y - 0.3 * p.x));
  });
}

NodeGrid steep_density(double extent_m, double mean_per_m2) {
  return grid_from(square_frame(extent_m, 1.0), [&](glm::dvec2 p) {
    return mean_per_m2 * (0.1 + 1.8 * unit_noise(11, std::lround(p.x), std::lround(p.y)));
  });
}

NodeGrid quarter_metre_density(double extent_m, double mean_per_m2) {
  return grid_from(square_frame(extent_m, 0.25), [&](glm::dvec2 p) {
    return mean_per_m2 * (0.1 + 1.8 * unit_noise(12, std::lround(4.0 * p.x), std::lround(4.0 * p.y)));
  });
}

Meadow rich_meadow(double extent_m) {
  Meadow meadow = level_meadow(extent_m, smooth_density(extent_m, 300.0));
  meadow.seed = 20;
  meadow.ground = HeightField(grid_from(square_frame(extent_m, 1.0), [](glm::dvec2 p) {
    return 120.0 + 3.0 * std::sin(0.4 * p.x) * std::cos(0.3 * p.y) + 0.8 * p.x +
           0.2 * unit_noise(13, std::lround(p.x), std::lround(p.y));
  }));
  meadow.species.push_back({test_grass(), steep_density(extent_m, 150.0)});
  meadow.species.back().species.params.height_m = 0.8f;
  meadow.species.back().species.params.clump_m = 0.6f;
  meadow.species.push_back({test_grass(), quarter_metre_density(extent_m, 80.0)});
  meadow.species.back().species.params.curvature_rad = 1.6f;
  meadow.blade_height = grid_from(square_frame(extent_m, 2.0), [](glm::dvec2 p) {
    return 0.5 + unit_noise(14, std::lround(p.x), std::lround(p.y));
  });
  meadow.bend = grid_from(square_frame(extent_m, 0.5), [](glm::dvec2 p) {
    return 0.7 + 0.6 * unit_noise(15, std::lround(2.0 * p.x), std::lround(2.0 * p.y));
  });
  const GridFrame frame = square_frame(extent_m, 1.0);
  std::vector<float> colors;
  for (int n = 0; n < 3 * frame.columns * frame.rows; ++n) {
    colors.push_back(static_cast<float>(0.8 + 0.2 * unit_noise(16, n, 0)));
  }
  meadow.color = NodeGrid(frame, 3, std::move(colors));
  return meadow;
}

}  // namespace prairie
