// The inner loop of planting: all blades of one prepared cell (generator/cell_table.h).
#pragma once

#include <span>

#include "shaders/shared/layouts.h"

namespace prairie {

/// Plants the cell's first `out.size()` blades; `tables` are the words that the cell indexes.
void plant_cell(const PlantedCell& cell, const SpeciesParams& species, std::span<const float> tables,
                std::span<Blade> out);

}  // namespace prairie
