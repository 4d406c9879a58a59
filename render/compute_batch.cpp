#include "render/compute_batch.h"

#include <cassert>
#include <cstdint>

namespace prairie {
namespace {

constexpr std::uint32_t kGroupSize = 64;  // local_size_x of shaders/pass/planting.glsl

}  // namespace

std::string_view planting_variant(bool has_features) {
  return has_features ? "FEATURE_MAPS" : "";
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

void ComputeBatch::set_tables(std::span<const float> tables, std::span<const SpeciesParams> species) {
  tables_.upload(tables);
  species_.upload(species);
}

void ComputeBatch::dispatch(GLuint program, std::span<DrawnCell> run, std::size_t element_bytes,
                            GlBuffer& output) {
  std::uint32_t blades = 0;
  for (DrawnCell& cell : run) {
    cell.first_blade = blades;
    blades += cell.drawn;
  }
  if (blades == 0) return;
  first_cell_of_group_.clear();
  std::uint32_t cell = 0;
  for (std::uint32_t blade = 0; blade < blades; blade += kGroupSize) {
    while (blade >= run[cell].first_blade + run[cell].drawn) ++cell;
    first_cell_of_group_.push_back(cell);
  }
  cells_.upload(std::span<const DrawnCell>(run));
  group_cells_.upload(std::span<const std::uint32_t>(first_cell_of_group_));
  output.reserve(blades * element_bytes);

  glUseProgram(program);
  const GLuint textures[] = {cells_.texture(), tables_.texture(), species_.texture(), group_cells_.texture()};
  glBindTextures(0, 4, textures);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 4, output.get());
  glProgramUniform1ui(program, 0, blades);
  glDispatchCompute((blades + kGroupSize - 1) / kGroupSize, 1, 1);
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

}  // namespace prairie
