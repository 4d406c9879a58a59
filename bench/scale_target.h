// Where benches draw: 8-bit colour and depth in place of a window.
#pragma once

#include <glm/vec2.hpp>

#include "render/gl/gl_objects.h"

namespace prairie {

class OffscreenTarget {
 public:
  explicit OffscreenTarget(glm::ivec2 size_px);
  GLuint framebuffer() const { return framebuffer_.get(); }
  glm::ivec2 size_px() const { return size_px_; }

 private:
  glm::ivec2 size_px_;
  GlTexture color_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace prairie
