#include "lod/cell_cache.h"

namespace prairie {
namespace {

constexpr std::uint64_t kFramesKept = 120;
constexpr std::uint64_t kFramesBetweenSweeps = 30;

std::uint64_t key_of(TileId tile, int cell) {
  const auto x = static_cast<std::uint32_t>(tile.i * kCellsPerSide + cell % kCellsPerSide);
  const auto y = static_cast<std::uint32_t>(tile.j * kCellsPerSide + cell / kCellsPerSide);
  return (static_cast<std::uint64_t>(y) << 32) | x;
}

}  // namespace

CellCache::CellCache(const Meadow& meadow) : meadow_(&meadow), lattice_(meadow) {}

const CellTables& CellCache::get(TileId tile, int cell) {
  const auto [entry, is_new] = entries_.try_emplace(key_of(tile, cell));
  if (is_new) append_cell(*meadow_, lattice_, tile, cell, entry->second.tables);
  entry->second.last_frame = frame_;
  return entry->second.tables;
}

void CellCache::end_frame() {
  ++frame_;
  if (frame_ % kFramesBetweenSweeps != 0) return;
  std::erase_if(entries_, [&](const auto& entry) { return entry.second.last_frame + kFramesKept < frame_; });
}

}  // namespace prairie
