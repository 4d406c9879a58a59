#include "generator/cell_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "generator/cell_lattice.h"
#include "generator/cell_seed.h"

namespace prairie {
namespace {

enum Stream : std::uint32_t { kSequence = 1, kAttributes, kCount, kRank };

struct CellPlace {
  glm::dvec2 origin_m;
  double side_m;
  int x;  // in cells from the scene's origin
  int y;
};

CellPlace place_of(const Meadow& meadow, TileId tile, int cell) {
  const double side_m = meadow.tile_m / kCellsPerSide;
  const int x = tile.i * kCellsPerSide + cell % kCellsPerSide;
  const int y = tile.j * kCellsPerSide + cell / kCellsPerSide;
  return {side_m * glm::dvec2(x, y), side_m, x, y};
}

bool inside_field(const Meadow& meadow, glm::dvec2 min_m, glm::dvec2 max_m) {
  if (meadow.repeats) return true;
  const double slack_m = 1e-6 * meadow.tile_m;
  return min_m.x >= -slack_m && min_m.y >= -slack_m && max_m.x <= meadow.extent_m.x + slack_m &&
         max_m.y <= meadow.extent_m.y + slack_m;
}

bool plantable(const Meadow& meadow, glm::dvec2 min_m, glm::dvec2 max_m) {
  return inside_field(meadow, min_m, max_m) && meadow.ground.has_data(min_m, max_m);
}

// A cell that the field's border crosses is cut as finely as can be, since a patch is planted whole or not at
// all.
int patches_at(const Meadow& meadow, const CellPlace& place, int usual_patches) {
  return plantable(meadow, place.origin_m, place.origin_m + place.side_m) ? usual_patches : kMaxPatches;
}

struct DensityPatches {
  int patches = 1;
  double patch_m = 1.0;
  double integral = 0.0;  // blades
  float nodes[(kMaxPatches + 1) * (kMaxPatches + 1)] = {};
  bool has_mass[kMaxPatches * kMaxPatches] = {};

  int corner(int row, int column) const { return row * (patches + 1) + column; }
  double lower_mean(int row, int column) const {
    return 0.5 * (static_cast<double>(nodes[corner(row, column)]) +
                  static_cast<double>(nodes[corner(row, column + 1)]));
  }
};

DensityPatches density_patches(const Meadow& meadow, const CellPlace& place, int species, int patches) {
  DensityPatches density;
  density.patches = patches;
  density.patch_m = place.side_m / patches;
  const std::size_t node_count = static_cast<std::size_t>((patches + 1) * (patches + 1));
  sample_cell_lattice(meadow.species[species].density_per_m2, place.origin_m, place.side_m, patches,
                      std::span(density.nodes).first(node_count));
  const bool whole = plantable(meadow, place.origin_m, place.origin_m + place.side_m);
  for (int row = 0; row < patches; ++row) {
    for (int column = 0; column < patches; ++column) {
      const double mean = 0.5 * (density.lower_mean(row, column) + density.lower_mean(row + 1, column));
      const glm::dvec2 min_m = place.origin_m + density.patch_m * glm::dvec2(column, row);
      const bool planted = mean > 0.0 && (whole || plantable(meadow, min_m, min_m + density.patch_m));
      density.has_mass[row * patches + column] = planted;  // false for NaN
      if (planted) density.integral += mean * density.patch_m * density.patch_m;
    }
  }
  for (std::size_t n = 0; n < node_count; ++n) {
    if (std::isnan(density.nodes[n])) density.nodes[n] = 0.0f;
  }
  return density;
}

void append_texel(std::vector<float>& tables, double x, double y, double z, double w) {
  for (const double value : {x, y, z, w}) tables.push_back(static_cast<float>(value));
}

std::uint32_t next_texel(const std::vector<float>& tables) {
  return static_cast<std::uint32_t>(tables.size() / 4);
}

// Layout: shaders/kernels/warp.glsl.
void append_density_table(const DensityPatches& density, std::vector<float>& tables) {
  const int m = density.patches;
  // edge 0: a row's lower, 1: its upper one
  const auto edge_sum = [&](int row, int edge, int columns) {
    double sum = 0.0;
    for (int c = 0; c < columns; ++c) {
      if (density.has_mass[row * m + c]) sum += density.lower_mean(row + edge, c);
    }
    return sum;
  };
  const auto node = [&](int row, int column) {
    return static_cast<double>(density.nodes[density.corner(row, column)]);
  };
  double total = 0.0;
  for (int row = 0; row < m; ++row) total += 0.5 * (edge_sum(row, 0, m) + edge_sum(row, 1, m));
  double below = 0.0;
  for (int row = 0; row < m; ++row) {
    const double lower = edge_sum(row, 0, m);
    const double upper = edge_sum(row, 1, m);
    append_texel(tables, below, lower, upper, total);
    below += 0.5 * (lower + upper);
  }
  for (int row = 0; row < m; ++row) {
    for (int column = 0; column <= m; ++column) {
      append_texel(tables, edge_sum(row, 0, column), edge_sum(row, 1, column), node(row, column),
                   node(row + 1, column));
    }
  }
}

// Layout: shaders/kernels/cell_ground.glsl.
void append_ground_table(const Meadow& meadow, const CellPlace& place, double base_m,
                         std::vector<float>& tables) {
  float heights_m[9];
  meadow.ground.sample_lattice(place.origin_m, 0.5 * place.side_m, 3, 3, heights_m);
  const auto height = [&](int n) { return static_cast<double>(heights_m[n]) - base_m; };
  for (int row = 0; row < 3; ++row)
    append_texel(tables, height(3 * row), height(3 * row + 1), height(3 * row + 2), 0.0);
}

// Layout: shaders/kernels/features.glsl.
void append_feature_table(const Meadow& meadow, const CellPlace& place, int patches,
                          std::vector<float>& tables) {
  constexpr std::size_t kNodes = (kMaxPatches + 1) * (kMaxPatches + 1);
  const std::size_t nodes = static_cast<std::size_t>((patches + 1) * (patches + 1));
  float lengths[kNodes];
  float bends[kNodes];
  float colors[3 * kNodes];
  sample_cell_lattice(meadow.blade_height, place.origin_m, place.side_m, patches,
                      std::span(lengths).first(nodes));
  sample_cell_lattice(meadow.bend, place.origin_m, place.side_m, patches, std::span(bends).first(nodes));
  if (meadow.color) {
    sample_cell_lattice(*meadow.color, place.origin_m, place.side_m, patches,
                        std::span(colors).first(3 * nodes));
  } else {
    std::fill(colors, colors + 3 * nodes, 1.0f);
  }
  const auto factor = [](float value) { return std::isfinite(value) ? static_cast<double>(value) : 1.0; };
  for (std::size_t n = 0; n < nodes; ++n) {
    append_texel(tables, factor(lengths[n]), factor(bends[n]), 0.0, 0.0);
    append_texel(tables, factor(colors[3 * n]), factor(colors[3 * n + 1]), factor(colors[3 * n + 2]), 0.0);
  }
}

/// The streams of a cell's species.
struct CellSeeds {
  std::uint64_t world_seed;
  CellPlace place;
  std::uint32_t species;

  std::uint64_t operator()(Stream stream) const {
    return cell_seed(world_seed, place.x, place.y, species, stream);
  }
};

/// The expectation, rounded at random so that it stays the expectation.
std::uint32_t rounded_count(const DensityPatches& density, const CellSeeds& seeds) {
  return static_cast<std::uint32_t>(std::floor(density.integral + unit_from_bits(seeds(kCount))));
}

/// What the species of a cell share.
struct CellSurroundings {
  glm::vec2 offset_m{0.0f};  // from the tile's corner
  std::uint32_t ground_table = kNoTable;
  std::uint32_t feature_table = kNoTable;
  std::uint32_t feature_patches = 0;
};

/// Appends a species' cell; its `other_density_per_m2` is its own until those of all species are known.
void append_planted(const SpeciesParams& params, const DensityPatches& density, const CellSeeds& seeds,
                    const CellSurroundings& around, CellTables& out) {
  const CellPlace& place = seeds.place;
  const glm::dvec2 clumps = place.origin_m / static_cast<double>(params.clump_m);
  const glm::dvec2 clump_floor(std::floor(clumps.x), std::floor(clumps.y));
  PlantedCell cell{};
  cell.key = {static_cast<std::uint32_t>(seeds(kSequence)), static_cast<std::uint32_t>(seeds(kAttributes))};
  cell.species = seeds.species;
  cell.planted = rounded_count(density, seeds);
  cell.offset_m = around.offset_m;
  cell.patch_m = static_cast<float>(density.patch_m);
  cell.patches = static_cast<std::uint32_t>(density.patches);
  cell.clump_lattice = glm::ivec2(clump_floor);
  cell.clump_offset = glm::vec2(clumps - clump_floor);
  cell.ground_table = around.ground_table;
  cell.density_table = next_texel(out.tables);
  cell.clump_seed = static_cast<std::uint32_t>(mix_bits(seeds.world_seed) >> 32);
  cell.feature_table = around.feature_table;
  cell.feature_patches = around.feature_patches;
  cell.side_m = static_cast<float>(place.side_m);
  cell.rank_offset = static_cast<float>(unit_from_bits(seeds(kRank)) * 0.998 + 0.001);
  cell.other_density_per_m2 = static_cast<float>(density.integral / (place.side_m * place.side_m));
  append_density_table(density, out.tables);
  out.cells.push_back(cell);
}

}  // namespace

PlantingLattice::PlantingLattice(const Meadow& meadow)
    : cell_m(meadow.tile_m / kCellsPerSide), feature_patches(0) {
  for (const PlantedSpecies& species : meadow.species) {
    density_patches.push_back(patches_for(species.density_per_m2, cell_m));
  }
  for (const NodeGrid* map : {&meadow.blade_height, &meadow.bend, meadow.color ? &*meadow.color : nullptr}) {
    if (map && !map->is_uniform()) feature_patches = std::max(feature_patches, patches_for(*map, cell_m));
  }
  const bool uniform_factor =
      (meadow.blade_height.is_uniform() && meadow.blade_height.sample({0.0, 0.0}) != 1.0f) ||
      (meadow.bend.is_uniform() && meadow.bend.sample({0.0, 0.0}) != 1.0f);
  if (uniform_factor) feature_patches = std::max(feature_patches, 1);
}

double tile_base_m(const Meadow& meadow, TileId tile) {
  return std::round(static_cast<double>(meadow.ground.height_m(tile_origin_m(meadow, tile))));
}

void append_cell(const Meadow& meadow, const PlantingLattice& lattice, TileId tile, int cell,
                 CellTables& out) {
  const CellPlace place = place_of(meadow, tile, cell);
  const std::size_t first_cell = out.cells.size();
  const double area_m2 = place.side_m * place.side_m;
  CellSurroundings around;
  around.offset_m = cell_offset_m(meadow, cell);
  around.feature_patches = static_cast<std::uint32_t>(lattice.feature_patches);
  double density_sum = 0.0;

  for (int s = 0; s < static_cast<int>(meadow.species.size()); ++s) {
    const DensityPatches density =
        density_patches(meadow, place, s, patches_at(meadow, place, lattice.density_patches[s]));
    density_sum += density.integral / area_m2;
    const CellSeeds seeds{meadow.seed, place, static_cast<std::uint32_t>(s)};
    if (rounded_count(density, seeds) == 0) continue;

    if (around.ground_table == kNoTable) {
      around.ground_table = next_texel(out.tables);
      append_ground_table(meadow, place, tile_base_m(meadow, tile), out.tables);
      if (lattice.feature_patches > 0) {
        around.feature_table = next_texel(out.tables);
        append_feature_table(meadow, place, lattice.feature_patches, out.tables);
      }
    }
    append_planted(meadow.species[s].species.params, density, seeds, around, out);
  }
  for (std::size_t n = first_cell; n < out.cells.size(); ++n) {
    PlantedCell& planted_cell = out.cells[n];
    planted_cell.other_density_per_m2 =
        static_cast<float>(density_sum - static_cast<double>(planted_cell.other_density_per_m2));
  }
}

CellTables uniform_cell(const SpeciesParams& species, float density_per_m2, double side_m,
                        std::uint64_t seed) {
  const CellPlace place{glm::dvec2(0.0), side_m, 0, 0};
  DensityPatches density;
  density.patch_m = side_m;
  std::fill(density.nodes, density.nodes + 4, density_per_m2);
  density.has_mass[0] = density_per_m2 > 0.0f;
  density.integral = static_cast<double>(density_per_m2) * side_m * side_m;
  CellTables tables;
  const CellSeeds seeds{seed, place, 0};
  if (rounded_count(density, seeds) == 0) return tables;
  CellSurroundings around;
  around.ground_table = 0;
  for (int row = 0; row < 3; ++row) append_texel(tables.tables, 0.0, 0.0, 0.0, 0.0);
  append_planted(species, density, seeds, around, tables);
  tables.cells.front().other_density_per_m2 = 0.0f;
  return tables;
}

std::array<float, 9> ground_heights_m(const CellTables& tables, const PlantedCell& cell) {
  std::array<float, 9> heights_m;
  for (std::size_t n = 0; n < heights_m.size(); ++n) {
    heights_m[n] = tables.tables[4 * (cell.ground_table + n / 3) + n % 3];
  }
  return heights_m;
}

std::vector<double> expected_cell_counts(const Meadow& meadow, const PlantingLattice& lattice, TileId tile,
                                         int cell) {
  const CellPlace place = place_of(meadow, tile, cell);
  std::vector<double> counts;
  for (int s = 0; s < static_cast<int>(meadow.species.size()); ++s) {
    counts.push_back(
        density_patches(meadow, place, s, patches_at(meadow, place, lattice.density_patches[s])).integral);
  }
  return counts;
}

}  // namespace prairie
