// Planting on the GPU with the blades read back: what tests compare with the CPU's and benches time. Pictures
// never read blades back.
#pragma once

#include <filesystem>
#include <vector>

#include "generator/cell_table.h"
#include "render/grass/compute_batch.h"

namespace prairie {

class GpuPlanting {
 public:
  explicit GpuPlanting(std::filesystem::path shader_folder);

  /// Uploads prepared cells; all their blades (together at most 128 MiB) will be planted.
  void prepare(const CellTables& tables, std::span<const SpeciesParams> species);
  /// Plants them and waits until it is done.
  void plant();
  /// The blades, in the cells' order.
  std::vector<Blade> read_back() const;

 private:
  std::filesystem::path shader_folder_;
  GlProgram program_;
  StreamBuffer stream_{std::size_t{1} << 20};
  ComputeBatch batch_;
  std::vector<float> tables_;
  std::vector<SpeciesParams> species_;
  std::vector<DrawnCell> cells_;
  std::size_t blade_count_ = 0;
  GlBuffer blades_{"planted blades"};
};

}  // namespace prairie
