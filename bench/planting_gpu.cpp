#include <chrono>
#include <vector>

#include "bench/benches.h"
#include "bench/timing.h"
#include "bench/varied_meadow.h"
#include "generator/cell_table.h"
#include "render/gl/context.h"
#include "render/grass/gpu_planting.h"

namespace prairie {
namespace {

constexpr int kRounds = 9;
// 1024 cells of about 4000 blades would exceed a storage buffer of 128 MiB.
constexpr std::size_t kMostBlades = kStorageLimitBytes / sizeof(Blade);

CellTables cells_within_limit(const Meadow& meadow) {
  const PlantingLattice lattice(meadow);
  CellTables all;
  std::size_t blades = 0;
  for (int j = 0; j < kVariedMeadowTiles; ++j) {
    for (int i = 0; i < kVariedMeadowTiles; ++i) {
      for (int cell = 0; cell < kCellsPerTile; ++cell) {
        CellTables next;
        append_cell(meadow, lattice, {i, j}, cell, next);
        if (blades + next.cells.front().planted > kMostBlades) return all;
        blades += next.cells.front().planted;
        append_cell(meadow, lattice, {i, j}, cell, all);
      }
    }
  }
  return all;
}

}  // namespace

std::vector<Measurement> bench_planting_gpu(const BenchOptions& options) {
  const HeadlessContext context(options.device);
  const Meadow meadow = varied_meadow();
  GpuPlanting planting(options.shader_folder);
  const std::vector<SpeciesParams> species = {meadow.species.front().species.params};
  planting.prepare(cells_within_limit(meadow), species);
  planting.plant();  // compiles the shader and makes room
  const auto blades = static_cast<double>(planting.read_back().size());
  std::vector<double> rounds;
  for (int round = 0; round < kRounds; ++round) {
    const auto start = std::chrono::steady_clock::now();
    planting.plant();
    rounds.push_back(
        std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / blades);
  }
  return {{"planting.gpu_ns_per_blade", median(rounds)}};
}

}  // namespace prairie
