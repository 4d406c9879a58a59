#include <chrono>
#include <vector>

#include "bench/benches.h"
#include "bench/timing.h"
#include "bench/varied_meadow.h"
#include "generator/plant.h"

namespace prairie {
namespace {

constexpr int kRounds = 7;

double blades_per_s(const Meadow& meadow) {
  const auto start = std::chrono::steady_clock::now();
  std::size_t blades = 0;
  for (int j = 0; j < kVariedMeadowTiles; ++j) {
    for (int i = 0; i < kVariedMeadowTiles; ++i) blades += plant_tile(meadow, {i, j}).size();
  }
  const std::chrono::duration<double> elapsed_s = std::chrono::steady_clock::now() - start;
  return static_cast<double>(blades) / elapsed_s.count();
}

}  // namespace

std::vector<Measurement> bench_planting_cpu(const BenchOptions&) {
  const Meadow meadow = varied_meadow();
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) rounds.push_back(blades_per_s(meadow));
  return {{"planting.cpu_blades_per_s_core", median(rounds)}};
}

}  // namespace prairie
