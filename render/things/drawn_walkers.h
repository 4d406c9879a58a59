// The world's walkers as they are drawn: those in sight, each in the pose that its feet and its body give it.
#pragma once

#include <vector>

#include "lod/camera.h"
#include "render/things/walker_look.h"
#include "world/world.h"

namespace prairie {

/// Walkers lower than a pixel are left out.
std::vector<WalkerLook> drawn_walkers(const World& world, const Camera& camera);

}  // namespace prairie
