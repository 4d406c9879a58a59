// Tiles and cells: the squares that planting counts in (docs/design.md, D2). Tile (0, 0) is the south-west
// one, i counts east, j north; a tile is planted as 2 × 2 cells, numbered 0 south-west, 1 south-east, 2
// north-west, 3 north-east.
#pragma once

#include <compare>
#include <cstdint>
#include <glm/vec2.hpp>

#include "generator/meadow.h"

namespace prairie {

inline constexpr int kCellsPerSide = 2;
inline constexpr int kCellsPerTile = kCellsPerSide * kCellsPerSide;

struct TileId {
  int i = 0;
  int j = 0;
  auto operator<=>(const TileId&) const = default;
};

/// Tiles from first to last, both inclusive.
struct TileRange {
  TileId first;
  TileId last;
  bool contains(TileId tile) const {
    return tile.i >= first.i && tile.i <= last.i && tile.j >= first.j && tile.j <= last.j;
  }
  std::int64_t count() const {
    return std::int64_t{last.i - first.i + 1} * std::int64_t{last.j - first.j + 1};
  }
};

/// Tiles that the field touches; where it repeats, those of one period from (0, 0).
TileRange tiles_of(const Meadow& meadow);

/// South-west corner of a tile, metres in the scene.
glm::dvec2 tile_origin_m(const Meadow& meadow, TileId tile);

/// South-west corner of a cell relative to its tile's, metres.
glm::vec2 cell_offset_m(const Meadow& meadow, int cell);

}  // namespace prairie
