#include "bench/scale_target.h"

namespace prairie {

OffscreenTarget::OffscreenTarget(glm::ivec2 size_px)
    : size_px_(size_px),
      color_(make_texture(GL_TEXTURE_2D, "bench color")),
      depth_(make_texture(GL_TEXTURE_2D, "bench depth")),
      framebuffer_(make_framebuffer("bench")) {
  glTextureStorage2D(color_.get(), 1, GL_RGBA8, size_px.x, size_px.y);
  glTextureStorage2D(depth_.get(), 1, GL_DEPTH_COMPONENT32F, size_px.x, size_px.y);
  glNamedFramebufferTexture(framebuffer_.get(), GL_COLOR_ATTACHMENT0, color_.get(), 0);
  glNamedFramebufferTexture(framebuffer_.get(), GL_DEPTH_ATTACHMENT, depth_.get(), 0);
}

}  // namespace prairie
