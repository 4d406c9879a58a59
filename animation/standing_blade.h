// A planted blade as treads and wind make it stand at a time: what a drawn blade of the virtual model is, on
// the CPU. Blades that move by themselves start from it and come back to it (animation/touched_blades.h).
#pragma once

#include <span>

#include "animation/chain_block.h"
#include "animation/condition_window.h"
#include "animation/sway.h"
#include "animation/treading.h"
#include "animation/wind.h"
#include "generator/cell_table.h"

namespace prairie {

/// All that moves blades, at the end of a step. `sway`: null in calm air.
struct Surroundings {
  const Meadow& meadow;
  std::span<const ChainTraits> species;
  const Wind& wind;
  const Treading& treading;
  const Sway* sway;
  double time_s;
  const ConditionWindow* conditions = nullptr;  // null where nothing has come over the grass
};

/// Positions are relative to the tile's corner and base, as the blade's.
struct StandingBlade {
  Blade blade;                // as worn
  glm::vec3 normal;           // of the ground
  Kernels::BladeCurve curve;  // at rest, as pressed
  ChainVectors rest;          // directions of its segments
  ChainVectors virtual_turn;  // from those, under wind and weight
  float least_rise;           // Kernels::lowest_rise
  float stiffness;            // in the condition that it is in
  glm::dvec2 place_m;         // in the scene
  const ChainTraits* species;

  Kernels::BladeChain chain(const ChainVectors& turn, float rise) const {
    return Kernels{}.turned_chain_over(blade, curve, 1.0f, turn, normal, rise);
  }
};

/// A blade where it was planted; neither is owned.
struct BladeOfCell {
  const PlantedCell* cell;
  const Blade* blade;
};

/// Blades of cells of a tile that `tables` hold, as shaders/pass/grow.comp poses them; as many as `found` has
/// room for. Each is what it would be alone; many at once cost less.
void find_standing(const Surroundings& around, TileId tile, const CellTables& tables,
                   std::span<const BladeOfCell> blades, std::span<StandingBlade> found);

}  // namespace prairie
