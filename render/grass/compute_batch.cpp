#include "render/grass/compute_batch.h"

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace prairie {
namespace {

constexpr std::uint32_t kGroupSize = layouts::kPlantingGroup;
constexpr std::size_t kMostGroups = 65535;  // the least that GL_MAX_COMPUTE_WORK_GROUP_COUNT may be

}  // namespace

std::string planting_variant(bool has_features) {
  return has_features ? "FEATURE_MAPS" : "";
}

std::size_t most_blades(std::size_t element_bytes) {
  return std::min(kStorageLimitBytes / element_bytes, kMostGroups * kGroupSize);
}

std::vector<DrawnCell> pieces_of(std::span<const DrawnCell> cells, std::size_t max_blades) {
  std::vector<DrawnCell> pieces;
  pieces.reserve(cells.size());
  for (const DrawnCell& cell : cells) {
    DrawnCell piece = cell;
    for (std::uint32_t first = 0; first < cell.drawn; first += piece.drawn) {
      piece.first_index = cell.first_index + first;
      piece.drawn = static_cast<std::uint32_t>(std::min<std::size_t>(cell.drawn - first, max_blades));
      pieces.push_back(piece);
    }
  }
  return pieces;
}

std::vector<CellRun> runs_of(std::span<const DrawnCell> cells, std::size_t max_blades) {
  std::vector<CellRun> runs;
  for (std::size_t n = 0; n < cells.size(); ++n) {
    if (runs.empty() || runs.back().blades + std::size_t{cells[n].drawn} > max_blades)
      runs.push_back({n, 0, 0});
    ++runs.back().count;
    runs.back().blades += cells[n].drawn;
  }
  return runs;
}

void ComputeBatch::set_tables(StreamBuffer& stream, std::span<const float> tables,
                              std::span<const SpeciesParams> species) {
  tables_.show(stream, tables);
  species_.show(stream, species);
}

std::uint32_t ComputeBatch::dispatch(StreamBuffer& stream, GLuint program, std::span<DrawnCell> run) {
  std::uint32_t blades = 0;
  for (DrawnCell& cell : run) {
    cell.first_blade = blades;
    blades += cell.drawn;
  }
  if (blades == 0) return 0;
  first_cell_of_group_.clear();
  std::uint32_t cell = 0;
  for (std::uint32_t blade = 0; blade < blades; blade += kGroupSize) {
    while (blade >= run[cell].first_blade + run[cell].drawn) ++cell;
    first_cell_of_group_.push_back(cell);
  }
  cells_.show(stream, std::span<const DrawnCell>(run));
  group_cells_.show(stream, std::span<const std::uint32_t>(first_cell_of_group_));
  glUseProgram(program);
  cells_.bind(layouts::kCellUnit);
  tables_.bind(layouts::kCellTableUnit);
  species_.bind(layouts::kSpeciesUnit);
  group_cells_.bind(layouts::kCellOfGroupUnit);
  glProgramUniform1ui(program, layouts::kPlantBladeCount, blades);
  glDispatchCompute((blades + kGroupSize - 1) / kGroupSize, 1, 1);
  return blades;
}

}  // namespace prairie
