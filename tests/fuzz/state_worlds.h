// The scenes that states are fuzzed against, small enough that loading takes next to no time.
#pragma once

#include <cstdint>

#include "world/world.h"

namespace prairie::fuzz {

/// Treads and touched blades; the largest part of a state in wind would be its texture.
inline World calm_world() {
  return World(
      parse_scene("version = 1\n[ground]\nsize_m = [8, 8]\n[[species]]\nname = \"a\"\ndensity = 20.0\n"
                  "[[mover]]\nname = \"stone\"\npath_m = [[1, 3], [6, 4]]\n",
                  "folder", {}),
      {});
}

/// As the first byte of an input says: the rest is a file, or what follows the header of one, which then
/// fits.
enum class StateInput : std::uint8_t { kFile, kBody };

}  // namespace prairie::fuzz
