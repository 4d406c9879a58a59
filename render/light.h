// The light of a scene: sun and sky as the shaders' frame block holds them.
#pragma once

#include "lod/frame_plan.h"
#include "shaders/shared/layouts.h"
#include "world/world.h"

namespace prairie {

/// What the frame block tells of the ground (render/ground_pass.h).
struct GroundLook {
  glm::dvec3 anchor_m{0.0};           // where the mesh's frame has its origin
  glm::dvec2 flat_period_m{1.0};      // size of the flat tier's texture in the scene
  glm::vec3 mean_transmission{0.0f};  // of the field's blades
};

/// The frame block of a plan, without jitter.
FrameParams frame_params(const World& world, const FramePlan& plan, const GroundLook& ground);

}  // namespace prairie
