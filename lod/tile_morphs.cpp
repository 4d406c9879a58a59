#include "lod/tile_morphs.h"

#include <algorithm>

namespace prairie {
namespace {

// How far a morphing tile lags behind the eye.
constexpr float kPlay = 0.02f;

std::uint64_t key_of(TileId tile) {
  return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(tile.j)) << 32) |
         static_cast<std::uint32_t>(tile.i);
}

}  // namespace

float TileMorphs::follow(TileId tile, float band, float grazing) {
  // Past 0 and 1 by the play, so that both are reached.
  float morph = std::clamp(band, -kPlay, grazing < 1.0f ? 1.0f : 1.0f + kPlay) * grazing;
  if (morph > -kPlay && morph < 1.0f + kPlay) {
    const std::uint64_t key = key_of(tile);
    if (const auto last = last_.find(key); last != last_.end())
      morph = std::clamp(last->second, morph - kPlay, morph + kPlay);
    next_[key] = morph;
  }
  return std::clamp(morph, 0.0f, 1.0f);
}

void TileMorphs::finish() {
  last_.swap(next_);
  next_.clear();
}

}  // namespace prairie
