// The light of a scene: sun and sky as the shaders' frame block holds them.
#pragma once

#include "lod/frame_plan.h"
#include "shaders/shared/layouts.h"
#include "world/world.h"

namespace prairie {

/// Everything of the frame block that depends on scene and camera. `anchor_m`: where the ground mesh's frame
/// has its origin.
FrameParams frame_params(const World& world, const FramePlan& plan, glm::dvec3 anchor_m);

}  // namespace prairie
