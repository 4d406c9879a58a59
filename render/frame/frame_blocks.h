// What all passes of a frame know (shaders/lib/frame_blocks.glsl): of the eye, of the light, of the field.
#pragma once

#include "lod/frame_plan.h"
#include "lod/sward/field_look.h"
#include "render/gl/stream_buffer.h"
#include "shaders/shared/layouts.h"
#include "world/world.h"

namespace prairie {

struct FrameBlocks {
  ViewParams view{};
  LightParams light{};
  FieldParams field{};
};

/// Of a plan, without jitter and tint; where moving fields lie is told by render/grass/moving_fields.h.
ViewParams view_params(const FramePlan& plan, const Meadow& meadow);

/// `flat_period_m`: size of the flat tier's texture in the scene (render/grass/ground_pass.h).
FieldParams field_params(const Meadow& meadow, const FieldLook& look, glm::dvec2 flat_period_m);

/// Of a world whose look from afar nobody asks for, seen by that camera.
FrameBlocks plain_blocks(const World& world, const Camera& camera);

/// For all that is drawn or computed from now on in this frame.
void bind(StreamBuffer& stream, const FrameBlocks& blocks);

}  // namespace prairie
