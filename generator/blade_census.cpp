#include "generator/blade_census.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/tiles.h"

namespace prairie {
namespace {

struct Box {
  glm::dvec2 min_m;
  glm::dvec2 max_m;
};

double area_m2(const Box& box) {
  return (box.max_m.x - box.min_m.x) * (box.max_m.y - box.min_m.y);
}

Box field_of(const Meadow& meadow) {
  if (!meadow.repeats) return {glm::dvec2(0.0), meadow.extent_m};
  const TileRange tiles = tiles_of(meadow);
  return {tile_origin_m(meadow, tiles.first), tile_origin_m(meadow, tiles.last) + meadow.tile_m};
}

/// Squares that no map's nodes lie inside of, as far as maps share a lattice: those of the finest one.
struct CensusLattice {
  glm::dvec2 origin_m{0.0};
  double step_m = 1.0;
  std::int64_t columns = 1;
  std::int64_t rows = 1;
  Box field;

  /// Cells from (i, j) up to (i_end, j_end), cut off where the field ends.
  Box box(std::int64_t i, std::int64_t j, std::int64_t i_end, std::int64_t j_end) const {
    const auto corner = [this](std::int64_t x, std::int64_t y) {
      return glm::clamp(origin_m + step_m * glm::dvec2(x, y), field.min_m, field.max_m);
    };
    return {corner(i, j), corner(i_end, j_end)};
  }
};

CensusLattice lattice_of(const Meadow& meadow) {
  CensusLattice lattice;
  lattice.field = field_of(meadow);
  const glm::dvec2 size_m = lattice.field.max_m - lattice.field.min_m;
  const GridFrame* finest = nullptr;
  const auto consider = [&](const GridFrame& frame) {
    if (finest == nullptr || frame.spacing_m < finest->spacing_m) finest = &frame;
  };
  for (const PlantedSpecies& species : meadow.species) {
    if (!species.density_per_m2.is_uniform()) consider(species.density_per_m2.frame());
  }
  // Ground without gaps has no say in what is planted.
  if (!meadow.ground.has_data(lattice.field.min_m, lattice.field.max_m)) consider(meadow.ground.frame());
  if (finest == nullptr) {
    lattice.origin_m = lattice.field.min_m;
    lattice.step_m = std::max(size_m.x, size_m.y);
    return lattice;
  }
  lattice.step_m = finest->spacing_m;
  const glm::dvec2 first = glm::floor((lattice.field.min_m - finest->origin_m) / lattice.step_m + 1e-6);
  lattice.origin_m = finest->origin_m + first * lattice.step_m;
  const glm::dvec2 count = glm::ceil((lattice.field.max_m - lattice.origin_m) / lattice.step_m - 1e-6);
  lattice.columns = static_cast<std::int64_t>(count.x);
  lattice.rows = static_cast<std::int64_t>(count.y);
  return lattice;
}

/// The nodes of a map that a box needs, in memory; nothing where the map does not reach it.
std::optional<NodeGrid> nodes_around(const NodeGrid& map, const Box& box) {
  const GridFrame& frame = map.frame();
  const glm::dvec2 low = glm::floor((box.min_m - frame.origin_m) / frame.spacing_m);
  const glm::dvec2 high = glm::ceil((box.max_m - frame.origin_m) / frame.spacing_m);
  glm::dvec2 first = low, last = high;
  if (!frame.repeats) {
    first = glm::max(low, glm::dvec2(0.0));
    last = glm::min(high, glm::dvec2(frame.columns - 1, frame.rows - 1));
  }
  if (!(first.x <= last.x && first.y <= last.y)) return std::nullopt;
  const NodeRect rect{static_cast<int>(first.x), static_cast<int>(first.y),
                      static_cast<int>(last.x - first.x) + 1, static_cast<int>(last.y - first.y) + 1};
  std::vector<float> values(static_cast<std::size_t>(rect.columns) * static_cast<std::size_t>(rect.rows));
  map.read_block(rect, values);
  return NodeGrid({.columns = rect.columns,
                   .rows = rect.rows,
                   .spacing_m = frame.spacing_m,
                   .origin_m = frame.origin_m + frame.spacing_m * first,
                   .repeats = false},
                  1, std::move(values));
}

/// Counts a square block of cells.
class BlockCensus {
 public:
  BlockCensus(const Meadow& meadow, const CensusLattice& lattice, std::int64_t i, std::int64_t j,
              std::int64_t i_end, std::int64_t j_end, int bin_cells)
      : meadow_(meadow),
        lattice_(lattice),
        first_i_(i),
        first_j_(j),
        bin_cells_(bin_cells),
        bin_columns_((i_end - i + bin_cells - 1) / bin_cells),
        blades_(meadow.species.size(), 0.0),
        bins_(static_cast<std::size_t>(bin_columns_ * ((j_end - j + bin_cells - 1) / bin_cells)), 0.0) {
    const Box box = lattice.box(i, j, i_end, j_end);
    for (const PlantedSpecies& species : meadow.species) {
      const bool varies = !species.density_per_m2.is_uniform();
      maps_.push_back(varies ? nodes_around(species.density_per_m2, box) : species.density_per_m2);
    }
    visit(i, j, i_end, j_end);
    for (std::size_t n = 0; n < bins_.size(); ++n) {
      const std::int64_t x = i + static_cast<std::int64_t>(n) % bin_columns_ * bin_cells;
      const std::int64_t y = j + static_cast<std::int64_t>(n) / bin_columns_ * bin_cells;
      const double bin_m2 = area_m2(lattice.box(x, y, x + bin_cells, y + bin_cells));
      if (bin_m2 > 0.0) densest_per_m2_ = std::max(densest_per_m2_, bins_[n] / bin_m2);
    }
  }

  const std::vector<double>& blades() const { return blades_; }
  double densest_per_m2() const { return densest_per_m2_; }

 private:
  /// Halves what lies on measured ground in part.
  void visit(std::int64_t i, std::int64_t j, std::int64_t i_end, std::int64_t j_end) {
    const Box box = lattice_.box(i, j, i_end, j_end);
    if (!(area_m2(box) > 0.0)) return;
    if (meadow_.ground.has_data(box.min_m, box.max_m)) return count(i, j, i_end, j_end);
    if (i_end - i == 1 && j_end - j == 1) return;
    if (i_end - i >= j_end - j) {
      const std::int64_t middle = i + (i_end - i) / 2;
      visit(i, j, middle, j_end);
      visit(middle, j, i_end, j_end);
    } else {
      const std::int64_t middle = j + (j_end - j) / 2;
      visit(i, j, i_end, middle);
      visit(i, middle, i_end, j_end);
    }
  }

  /// The mean of a bilinear function over a rectangle is its value in the middle.
  void count(std::int64_t i, std::int64_t j, std::int64_t i_end, std::int64_t j_end) {
    for (std::int64_t y = j; y < j_end; ++y) {
      for (std::int64_t x = i; x < i_end; ++x) {
        const Box cell = lattice_.box(x, y, x + 1, y + 1);
        const double cell_m2 = area_m2(cell);
        const glm::dvec2 middle_m = 0.5 * (cell.min_m + cell.max_m);
        double& bin = bins_[static_cast<std::size_t>((y - first_j_) / bin_cells_ * bin_columns_ +
                                                     (x - first_i_) / bin_cells_)];
        for (std::size_t s = 0; s < maps_.size(); ++s) {
          const double density_per_m2 = maps_[s] ? static_cast<double>(maps_[s]->sample(middle_m)) : 0.0;
          if (!(density_per_m2 > 0.0)) continue;
          blades_[s] += density_per_m2 * cell_m2;
          bin += density_per_m2 * cell_m2;
        }
      }
    }
  }

  const Meadow& meadow_;
  const CensusLattice& lattice_;
  std::int64_t first_i_, first_j_;
  int bin_cells_;
  std::int64_t bin_columns_;
  std::vector<std::optional<NodeGrid>> maps_;
  std::vector<double> blades_;
  std::vector<double> bins_;
  double densest_per_m2_ = 0.0;
};

}  // namespace

BladeCensus blade_census(const Meadow& meadow) {
  const CensusLattice lattice = lattice_of(meadow);
  constexpr double kLeastBlockCells = 128.0;
  const int bin_cells = std::max(1, static_cast<int>(std::lround(meadow.tile_m / lattice.step_m)));
  const std::int64_t block = bin_cells * static_cast<std::int64_t>(std::ceil(kLeastBlockCells / bin_cells));
  const auto block_rows = static_cast<std::size_t>((lattice.rows + block - 1) / block);
  std::vector<BladeCensus> of_rows(block_rows);
  tbb::parallel_for(std::size_t{0}, block_rows, [&](std::size_t row) {
    BladeCensus& census = of_rows[row];
    census.blades.assign(meadow.species.size(), 0.0);
    const std::int64_t j = static_cast<std::int64_t>(row) * block;
    for (std::int64_t i = 0; i < lattice.columns; i += block) {
      const BlockCensus of_block(meadow, lattice, i, j, std::min(i + block, lattice.columns),
                                 std::min(j + block, lattice.rows), bin_cells);
      for (std::size_t s = 0; s < census.blades.size(); ++s) census.blades[s] += of_block.blades()[s];
      census.densest_per_m2 = std::max(census.densest_per_m2, of_block.densest_per_m2());
    }
  });
  BladeCensus total{.blades = std::vector<double>(meadow.species.size(), 0.0)};
  for (const BladeCensus& census : of_rows) {
    for (std::size_t s = 0; s < total.blades.size(); ++s) total.blades[s] += census.blades[s];
    total.densest_per_m2 = std::max(total.densest_per_m2, census.densest_per_m2);
  }
  return total;
}

}  // namespace prairie
