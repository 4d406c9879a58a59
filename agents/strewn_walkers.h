// Where the walkers of a crowd begin: strewn over the discs of their groups, or at places that are given, on
// free ground and apart from one another.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "agents/crowd_spec.h"
#include "agents/obstacle_map.h"
#include "agents/walker.h"

namespace prairie {

struct StrewnWalkers {
  std::vector<Walker> walkers;
  std::vector<WalkerTraits> traits;  // of each
};

/// A function of its arguments alone. Throws BadInput, the field in it, on groups out of range, places inside
/// of obstacles or of one another, or where there is no room.
StrewnWalkers strewn_walkers(std::span<const WalkerGroup> groups, const ObstacleMap& obstacles,
                             std::uint32_t seed);

}  // namespace prairie
