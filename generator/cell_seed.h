// Seeds of cells: 64-bit mixes of (world seed, cell, species), so that no two cells share a stream however
// many there are.
#pragma once

#include <cstdint>

namespace prairie {

/// S. Vigna's SplitMix64 finaliser.
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

/// Seed of stream `stream` of a cell, in which `cell_x`, `cell_y` count cells from the scene's origin.
constexpr std::uint64_t cell_seed(std::uint64_t world_seed, int cell_x, int cell_y, std::uint32_t species,
                                  std::uint32_t stream) {
  const std::uint64_t place = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(cell_y)) << 32) |
                              static_cast<std::uint32_t>(cell_x);
  const std::uint64_t kind = (static_cast<std::uint64_t>(stream) << 32) | species;
  return mix_bits(mix_bits(mix_bits(world_seed) ^ place) ^ kind);
}

/// [0, 1), 53 bits.
constexpr double unit_from_bits(std::uint64_t bits) {
  return static_cast<double>(bits >> 11) * 0x1.0p-53;
}

}  // namespace prairie
