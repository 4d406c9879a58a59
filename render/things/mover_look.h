// What the things that move over the grass (agents/mover.h) look like: a stone is a granite boulder, a cart
// is of boards and runs on four spoked wheels, which turn as it goes.
#pragma once

#include <vector>

#include "render/things/solid_pass.h"
#include "world/world.h"

namespace prairie {

/// Of all movers, where they are at the world's time, and after them of all driven ones.
std::vector<DrawnSolid> drawn_movers(const World& world);

}  // namespace prairie
