#include "tests/generator/hashed_meadow.h"

#include "generator/cell_seed.h"
#include "generator/plant.h"

namespace prairie {
namespace {

constexpr double kExtentM = 24.0;

double noise(std::uint64_t seed, std::uint64_t node) {
  return unit_from_bits(mix_bits(mix_bits(seed) ^ node));
}

/// Values between low and high at random nodes.
NodeGrid noise_grid(std::uint64_t seed, GridFrame frame, int channels, double low, double high) {
  std::vector<float> values;
  for (std::uint64_t n = 0; n < static_cast<std::uint64_t>(frame.columns * frame.rows * channels); ++n) {
    values.push_back(static_cast<float>(low + (high - low) * noise(seed, n)));
  }
  return NodeGrid(frame, channels, std::move(values));
}

GridFrame frame_of(double spacing_m, glm::dvec2 origin_m) {
  const int nodes = static_cast<int>((kExtentM - origin_m.x) / spacing_m) + 2;
  return {nodes, nodes, spacing_m, origin_m, false};
}

PlantedSpecies species(float height_m, float clump_m, NodeGrid density) {
  PlantedSpecies species{{}, std::move(density)};
  SpeciesParams& p = species.species.params;
  p.height_m = height_m;
  p.height_spread = 0.4f;
  p.width_m = 0.004f;
  p.width_spread = 0.3f;
  p.tilt_rad = 0.4f;
  p.lean_rad = 0.5f;
  p.curvature_rad = 0.9f;
  p.curvature_spread = 0.5f;
  p.dry_share = 0.2f;
  p.dry_spread = 0.3f;
  p.hue_spread = 0.4f;
  p.mass_g = 0.05f;
  p.stiffness = 4.0f;
  p.stiffness_spread = 0.3f;
  p.clump_m = clump_m;
  p.clump_strength = 0.7f;
  p.clump_spray_rad = 0.3f;
  return species;
}

Meadow hashed_meadow() {
  Meadow meadow;
  meadow.seed = 0x5eed;
  meadow.extent_m = glm::dvec2(kExtentM);
  meadow.ground = HeightField(noise_grid(1, frame_of(2.0, {0.0, 0.0}), 1, 200.0, 204.0));
  meadow.species.push_back(species(0.2f, 0.2f, noise_grid(2, frame_of(4.0, {0.0, 0.0}), 1, 0.0, 400.0)));
  meadow.species.push_back(species(0.6f, 0.7f, noise_grid(3, frame_of(0.25, {0.0, 0.0}), 1, 0.0, 200.0)));
  meadow.species.push_back(species(0.4f, 0.4f, noise_grid(4, frame_of(0.7, {-0.4, -0.4}), 1, 0.0, 100.0)));
  meadow.blade_height = noise_grid(5, frame_of(1.0, {0.0, 0.0}), 1, 0.5, 1.5);
  meadow.bend = noise_grid(6, frame_of(3.0, {0.0, 0.0}), 1, 0.5, 1.5);
  meadow.color = noise_grid(7, frame_of(1.0, {0.0, 0.0}), 3, 0.5, 1.0);
  return meadow;
}

}  // namespace

std::uint64_t hashed_meadow_hash() {
  const Meadow meadow = hashed_meadow();
  std::uint64_t hash = 0;
  for (const std::uint64_t tile : tile_hashes(meadow, tiles_of(meadow))) hash = mix_bits(hash ^ tile);
  return hash;
}

}  // namespace prairie
