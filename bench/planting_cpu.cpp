#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include "bench/benches.h"
#include "generator/plant.h"

namespace prairie {
namespace {

constexpr int kTilesPerSide = 16;
constexpr int kRounds = 7;

Meadow varied_meadow() {
  Meadow meadow;
  const double side_m = kTilesPerSide * meadow.tile_m;
  meadow.extent_m = {side_m, side_m};
  GridFrame frame;
  frame.columns = frame.rows = static_cast<int>(side_m) + 1;
  std::vector<float> density_per_m2;
  for (int row = 0; row < frame.rows; ++row) {
    for (int column = 0; column < frame.columns; ++column) {
      density_per_m2.push_back(1000.0f + 500.0f * std::sin(0.7f * static_cast<float>(column)) *
                                             std::cos(0.4f * static_cast<float>(row)));
    }
  }
  PlantedSpecies grass;
  grass.species.name = "grass";
  grass.species.params.height_m = 0.5f;
  grass.species.params.height_spread = 0.3f;
  grass.species.params.width_m = 0.006f;
  grass.species.params.clump_m = 0.5f;
  grass.species.params.clump_strength = 0.5f;
  grass.density_per_m2 = NodeGrid(frame, 1, density_per_m2);
  meadow.species.push_back(grass);
  return meadow;
}

double blades_per_s(const Meadow& meadow) {
  const auto start = std::chrono::steady_clock::now();
  std::size_t blades = 0;
  for (int j = 0; j < kTilesPerSide; ++j) {
    for (int i = 0; i < kTilesPerSide; ++i) blades += plant_tile(meadow, {i, j}).size();
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
  return static_cast<double>(blades) / passed.count();
}

}  // namespace

double planting_cpu_blades_per_s_core(const BenchOptions&) {
  const Meadow meadow = varied_meadow();
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) rounds.push_back(blades_per_s(meadow));
  // The median: other work on the machine only ever makes a round slower, a turbo clock only the first ones
  // faster.
  std::ranges::nth_element(rounds, rounds.begin() + kRounds / 2);
  return rounds[kRounds / 2];
}

}  // namespace prairie
