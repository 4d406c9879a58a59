// What things that stand in the meadow are made of, and how large a surface each texture of a material shows
// before it repeats (render/things/obstacle_texture.h).
#pragma once

#include <cstddef>
#include <cstdint>

namespace prairie {

/// In the order of the textures' layers.
enum class ObstacleMaterial : std::uint8_t { kBark, kEndGrain, kGranite, kBoards, kDryStone };
inline constexpr std::size_t kObstacleMaterials = 5;

/// What the textures are wide before they repeat, metres.
inline constexpr double kBarkM = 1.2;
inline constexpr double kGraniteM = 1.3;
inline constexpr double kBoardM = 0.14;  // a board's width; kBoardsOnMap of them lie above one another
inline constexpr double kBoardsOnMap = 8.0;
inline constexpr double kBoardLengthM = 2.24;
inline constexpr double kDryStoneM = 1.6;  // along
inline constexpr double kDryStoneHighM = 1.2;

}  // namespace prairie
