// Feeds cells to the planting shaders (shaders/lib/planting.glsl): a batch of cells is as large as one
// storage buffer of output allows; one invocation plants one blade.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "render/gl/texel_view.h"
#include "shaders/shared/layouts.h"

namespace prairie {

inline constexpr std::size_t kStorageLimitBytes = std::size_t{128}
                                                  << 20;  // Mesa's software renderer; the least to expect

/// Cells [first, first + count) of a list, whose blades fit into one buffer.
struct CellRun {
  std::size_t first = 0;
  std::size_t count = 0;
  std::uint32_t blades = 0;
};

/// Blades of `element_bytes` that one dispatch can write: a storage buffer's worth, and no more workgroups
/// than every driver takes.
std::size_t most_blades(std::size_t element_bytes);

/// The cells, those of more than `max_blades` blades cut into pieces.
std::vector<DrawnCell> pieces_of(std::span<const DrawnCell> cells, std::size_t max_blades);

/// Cuts cells of at most `max_blades` blades into runs of at most as many.
std::vector<CellRun> runs_of(std::span<const DrawnCell> cells, std::size_t max_blades);

/// The preprocessor name with which planting shaders are made where feature maps vary; empty elsewhere.
std::string planting_variant(bool has_features);

class ComputeBatch {
 public:
  /// Shows all runs of a frame what they share.
  void set_tables(StreamBuffer& stream, std::span<const float> tables,
                  std::span<const SpeciesParams> species);
  /// Numbers the run's blades (`first_blade`), shows its cells and runs `program` over them, which writes
  /// into the bound result buffer. Returns the number of blades.
  std::uint32_t dispatch(StreamBuffer& stream, GLuint program, std::span<DrawnCell> run);

 private:
  TexelView cells_{GL_RGBA32UI, "cells"};
  TexelView tables_{GL_RGBA32F, "cell tables"};
  TexelView species_{GL_RGBA32F, "species"};
  TexelView group_cells_{GL_R32UI, "cells of workgroups"};
  std::vector<std::uint32_t> first_cell_of_group_;
};

}  // namespace prairie
