#include "render/grass/gpu_planting.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "render/gl/shader_program.h"

namespace prairie {

GpuPlanting::GpuPlanting(std::filesystem::path shader_folder) : shader_folder_(std::move(shader_folder)) {}

void GpuPlanting::prepare(const CellTables& tables, std::span<const SpeciesParams> species) {
  cells_.clear();
  blade_count_ = 0;
  for (const PlantedCell& planted : tables.cells) {
    DrawnCell cell{};
    cell.planted = planted;
    cell.drawn = planted.planted;
    cells_.push_back(cell);
    blade_count_ += planted.planted;
  }
  assert(blade_count_ * sizeof(Blade) <= kStorageLimitBytes);
  blades_.reserve(blade_count_ * sizeof(Blade));
  tables_ = tables.tables;
  species_.assign(species.begin(), species.end());
  const bool has_features =
      std::any_of(tables.cells.begin(), tables.cells.end(),
                  [](const PlantedCell& cell) { return cell.feature_table != kNoTable; });
  program_ = make_program(shader_folder_, {"pass/plant.comp"}, {planting_variant(has_features)});
}

void GpuPlanting::plant() {
  stream_.begin_frame();
  batch_.set_tables(stream_, tables_, species_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layouts::kResultBuffer, blades_.get());
  batch_.dispatch(stream_, program_.get(), cells_);
  glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
  glFinish();
}

std::vector<Blade> GpuPlanting::read_back() const {
  std::vector<Blade> blades(blade_count_);
  glGetNamedBufferSubData(blades_.get(), 0, static_cast<GLsizeiptr>(blades.size() * sizeof(Blade)),
                          blades.data());
  return blades;
}

}  // namespace prairie
