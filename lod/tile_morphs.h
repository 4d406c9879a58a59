// How far tiles have morphed from 3D blades to strips, from plan to plan: a tile's morph follows the eye only
// when it is off by more than a little play (hysteresis), so that an eye that trembles at a band does not
// make grass breathe.
#pragma once

#include <cstdint>
#include <unordered_map>

#include "generator/tiles.h"

namespace prairie {

class TileMorphs {
 public:
  /// The morph of a tile in this plan, 0…1: `band` is how far the eye is in the band of distances (below 0
  /// before it, above 1 beyond), `grazing` the share of it that the slant of the view allows.
  float follow(TileId tile, float band, float grazing);
  /// The plan is made; tiles that it did not ask for are forgotten.
  void finish();
  void forget() { last_.clear(); }

 private:
  std::unordered_map<std::uint64_t, float> last_;  // of the tiles of the last plan that morphed
  std::unordered_map<std::uint64_t, float> next_;  // and of the plan being made
};

}  // namespace prairie
