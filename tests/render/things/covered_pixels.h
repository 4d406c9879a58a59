// Which pixels something covers that is drawn by itself.
#pragma once

#include <vector>

#include "render/gl/render_target.h"
#include "render/gl/stream_buffer.h"
#include "render/light/light.h"
#include "world/world.h"

namespace prairie {

/// Rows from the top. `draw(stream)` prepares and draws it; the frame block is that of an empty frame of this
/// world.
template <class Draw>
std::vector<bool> covered_pixels(const World& world, const Camera& camera, Draw draw) {
  StreamBuffer stream(std::size_t{1} << 16);
  stream.begin_frame();
  FramePlan plan;
  plan.camera = camera;
  const FrameParams frame = frame_params(world, plan, GroundLook{}, FieldLook{});
  const StreamBuffer::Slice block = stream.write(&frame, sizeof(frame));
  glBindBufferRange(GL_UNIFORM_BUFFER, 0, block.buffer, block.offset, sizeof(frame));
  const RenderTarget target(camera.size_px, false);
  target.begin();
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
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
