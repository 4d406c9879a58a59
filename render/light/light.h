// The light of a scene: sun and sky as the shaders' frame block holds them.
#pragma once

#include "lod/frame_plan.h"
#include "render/grass/sward_tables.h"
#include "shaders/shared/layouts.h"
#include "world/world.h"

namespace prairie {

/// What the frame block tells of the ground (render/grass/ground_pass.h).
struct GroundLook {
  glm::dvec3 anchor_m{0.0};       // where the mesh's frame has its origin
  glm::dvec2 flat_period_m{1.0};  // size of the flat tier's texture in the scene
};

/// The frame block of a plan, without jitter and tint.
FrameParams frame_params(const World& world, const FramePlan& plan, const GroundLook& ground,
                         const FieldLook& field);

}  // namespace prairie
