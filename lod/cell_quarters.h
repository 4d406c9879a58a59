// Quarters of cells (shaders/kernels/quarter.glsl): where their blades can stand and how many of a prefix are
// theirs.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "generator/cell_table.h"

namespace prairie {

struct CellQuarter {
  std::uint32_t code;  // DrawnCell::quarter
  glm::vec2 min_m;     // bounds of its roots, relative to the cell's south-west corner
  glm::vec2 max_m;
};

/// South-west, south-east, north-west, north-east. Where the density varies they overlap a little.
std::array<CellQuarter, 4> quarters_of(const PlantedCell& cell, const std::vector<float>& tables);

/// How many of a cell's first `drawn` blades stand in the quarter.
std::uint32_t drawn_in_quarter(std::uint32_t code, std::uint32_t drawn);

}  // namespace prairie
