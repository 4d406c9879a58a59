// Which pixels something covers that is drawn by itself.
#pragma once

#include <vector>

#include "render/frame/frame_blocks.h"
#include "render/gl/draw_state.h"
#include "render/gl/render_target.h"
#include "render/gl/stream_buffer.h"
#include "world/world.h"

namespace prairie {

/// Rows from the top. `draw(stream)` prepares and draws it with that state; the frame's blocks are those of
/// an empty frame of this world.
template <class Draw>
std::vector<bool> covered_pixels(const World& world, const Camera& camera, const DrawState& state,
                                 Draw draw) {
  StreamBuffer stream(std::size_t{1} << 16);
  stream.begin_frame();
  bind(stream, plain_blocks(world, camera));
  const RenderTarget target(camera.size_px, false);
  target.begin();
  set_draw_state(state);
  draw(stream);
  std::vector<float> pixels(std::size_t{4} * camera.size_px.x * camera.size_px.y);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target.resolved_framebuffer());
  glReadPixels(0, 0, camera.size_px.x, camera.size_px.y, GL_RGBA, GL_FLOAT, pixels.data());
  std::vector<bool> covered;
  for (int row = camera.size_px.y; row-- > 0;) {
    for (int column = 0; column < camera.size_px.x; ++column)
      covered.push_back(pixels[4 * (static_cast<std::size_t>(row) * camera.size_px.x + column)] > 0.0f);
  }
  return covered;
}

}  // namespace prairie
