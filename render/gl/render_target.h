// Where a frame is drawn: linear radiance in half floats and a reversed depth buffer, optionally with 4
// samples per pixel; and where jittered frames are added up.
#pragma once

#include <glm/vec2.hpp>

#include "render/gl/gl_objects.h"

namespace prairie {

class RenderTarget {
 public:
  RenderTarget(glm::ivec2 size_px, bool msaa);

  glm::ivec2 size_px() const { return size_px_; }
  bool msaa() const { return msaa_; }
  /// Binds for drawing and clears.
  void begin() const;
  /// The frame with one sample per pixel (samples of a pixel averaged).
  GLuint resolved() const;
  GLuint resolved_framebuffer() const;

 private:
  glm::ivec2 size_px_;
  bool msaa_;
  GlTexture color_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
  GlTexture resolved_color_;
  GlFramebuffer resolved_framebuffer_;
};

}  // namespace prairie
