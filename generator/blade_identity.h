// Which blade a blade is: together with the tile and the seed, its identity names it for good, whatever is
// edited.
#pragma once

#include <cstdint>

#include "shaders/shared/layouts.h"

namespace prairie {

struct BladeIdentity {
  std::uint32_t species = 0;
  std::uint32_t cell = 0;   // of its tile: 0 south-west, 1 south-east, 2 north-west, 3 north-east
  std::uint32_t index = 0;  // in the cell's sequence
};

/// Unpacks Blade::identity: 6 bits of species, 2 of cell, 24 of index.
constexpr BladeIdentity identity_of(const Blade& blade) {
  return {blade.identity >> 26, (blade.identity >> 24) & 3u, blade.identity & 0xffffffu};
}

}  // namespace prairie
