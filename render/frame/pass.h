// A frame is an ordered list of passes. Each is told here as plain data, so that whoever draws something of
// its own, such as an editor, adds it to the list.
#pragma once

#include <cstdint>
#include <functional>

#include "lod/frame_plan.h"
#include "render/frame/frame_options.h"
#include "render/gl/draw_state.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/moving_program.h"

namespace prairie {

class World;

/// The view that a pass draws for.
struct ViewInputs {
  const World& world;
  const FramePlan& plan;
  const FrameOptions& options;
  GrassVariant variant;  // that the world's motion asks for
  float sward_height_m;  // mean of standing blades
  StreamBuffer& stream;  // what is written there is valid for this frame
};

struct Pass {
  const char* name = "";  // in statistics
  DrawState state;        // set before `draw`
  /// Reads all that time moves and hands the view's share to the device; returns whether there is anything to
  /// draw. The frame's blocks, the sward's tables and the moving fields are bound.
  std::function<bool(const ViewInputs&)> prepare;
  /// Draws it into the bound target, perhaps several times; may not read what time moves.
  std::function<void(const ViewInputs&)> draw;
  /// Of what was drawn last; none where overlays are drawn.
  std::function<std::uint64_t()> triangles = [] { return std::uint64_t{0}; };
};

}  // namespace prairie
