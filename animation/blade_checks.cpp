#include "animation/blade_checks.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "animation/handover.h"
#include "animation/range_check.h"
#include "animation/tread_checks.h"
#include "files/error.h"

namespace prairie {
namespace {

// Many times as many as lie in the reach of an eye.
constexpr std::size_t kMostCells = std::size_t{1} << 16;
// Segments turn by at most π, an offset is the difference of two turns, and both come with rounding.
constexpr float kMostTurnRad = std::numbers::pi_v<float> + 1e-3f;
constexpr float kMostOffsetRad = 2.0f * kMostTurnRad;
// Half a turn in a microsecond.
constexpr float kMostRateRadPerS = 4e6f;
constexpr float kMostUnit = 1.001f;

// Not so written as to let NaN pass. Names and texts only where they are needed: there may be millions of
// numbers.
void check_vectors(const char* field, const ChainVectors& vectors, float most) {
  for (const glm::vec3& v : {vectors.v1, vectors.v2, vectors.v3, vectors.v4}) {
    for (const float number : {v.x, v.y, v.z}) {
      if (std::abs(number) <= most) continue;
      const auto bound = static_cast<double>(most);
      check_range(field, static_cast<double>(number), -bound, bound);
    }
  }
}

void check_place(const char* field, glm::dvec2 place_m) {
  check_range(field, place_m.x, -kFarthestM, kFarthestM, "metres");
  check_range(field, place_m.y, -kFarthestM, kFarthestM, "metres");
}

void check_blade(const TouchedBlade& blade) {
  check_vectors("touched.turn", blade.motion.turn, kMostTurnRad);
  check_vectors("touched.rate", blade.motion.rate, kMostRateRadPerS);
  check_vectors("touched.rest", blade.rest, kMostUnit);
  check_vectors("touched.offset", blade.offset, kMostOffsetRad);
  const bool is_fine = std::abs(blade.rise) <= kMostUnit && blade.near_steps >= 0 &&
                       blade.near_steps <= SpentMotion::kSteps && (blade.fades == 0 || blade.fades == 1);
  if (is_fine) return;
  check_range("touched.rise", static_cast<double>(blade.rise), static_cast<double>(-kMostUnit),
              static_cast<double>(kMostUnit), "a sine");
  check_range("touched.near_steps", blade.near_steps, 0.0, SpentMotion::kSteps);
  check_range("touched.fades", blade.fades, 0.0, 1.0);
}

void check_cell(const CellId& id, const Meadow& meadow) {
  const auto refuse = [&](const char* expected) {
    throw BadInput("", "touched.cell", fmt::format("cell {} of tile {}, {}", id.cell, id.tile.i, id.tile.j),
                   expected);
  };
  if (id.cell < 0 || id.cell >= kCellsPerTile) refuse("cell 0 to 3");
  if (meadow.repeats) {
    check_place("touched.tile", tile_origin_m(meadow, id.tile));
  } else if (!tiles_of(meadow).contains(id.tile)) {
    refuse("a tile of the meadow");
  }
}

}  // namespace

void check_state(const SwayState& state) {
  check_place("sway.centre_m", state.centre_m);
  for (const ChainMotion& motion : state.motions) {
    check_vectors("sway.turn", motion.turn, kMostTurnRad);
    check_vectors("sway.rate", motion.rate, kMostRateRadPerS);
  }
}

void check_state(const TouchedState& state, const Meadow& meadow) {
  if (state.size() > kMostCells)
    throw BadInput("", "touched", fmt::format("{} cells", state.size()),
                   fmt::format("at most {}", kMostCells));
  const CellId* last_cell = nullptr;
  for (const auto& [id, blades] : state) {
    if (last_cell != nullptr && !(*last_cell < id))
      throw BadInput("", "touched.cell", "cells out of order or twice", "each once, in order");
    last_cell = &id;
    check_cell(id, meadow);
    if (blades.empty()) throw BadInput("", "touched.cell", "a cell without touched blades", "at least one");
    const TouchedBlade* last = nullptr;
    for (const TouchedBlade& blade : blades) {
      if (last != nullptr && blade.index <= last->index)
        throw BadInput("", "touched.index", fmt::format("{} after {}", blade.index, last->index),
                       "each blade once, in order");
      last = &blade;
      if (blade.index >= kMostTouchable)
        throw BadInput("", "touched.index", fmt::format("{}", blade.index),
                       fmt::format("less than {}", kMostTouchable));
      check_blade(blade);
    }
  }
}

}  // namespace prairie
