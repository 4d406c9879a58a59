// The standard views of one tile, for tile screenshots: the same framing for every tile and picture size, so
// that pictures of different tiers, seeds and scenes can be laid side by side.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <string_view>

#include "generator/tiles.h"
#include "lod/camera.h"

namespace prairie {

enum class TileView {
  kTop,      // straight down, parallel projection, north at the top; the tile fills the shorter side
  kOblique,  // 45° down from the south, the whole tile with its blades in view
  kEye,      // a person 3 m south of the tile who looks at its middle
};

inline constexpr std::array<TileView, 3> kTileViews{TileView::kTop, TileView::kOblique, TileView::kEye};

std::string_view tile_view_name(TileView view);

/// `tallest_m`: no blade of the meadow is longer (generator/meadow.h).
Camera tile_camera(const Meadow& meadow, double tallest_m, TileId tile, TileView view, glm::ivec2 size_px);

}  // namespace prairie
