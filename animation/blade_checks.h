// What swaying and touched blades accept from outside; every fault is a BadInput that names the field and
// what was expected.
#pragma once

#include "animation/sway.h"
#include "animation/touched_blades.h"
#include "generator/meadow.h"

namespace prairie {

/// Indices of touched blades, and all blades that their cells hold, stay below this.
inline constexpr std::uint32_t kMostTouchable = 1u << 24;

/// Centre and motions; that there are as many as the species need is the caller's business.
void check_state(const SwayState& state);

/// All that can be told without planting: cells of the meadow and their blades each once and in order, and
/// numbers in their ranges.
void check_state(const TouchedState& state, const Meadow& meadow);

}  // namespace prairie
