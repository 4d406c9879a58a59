#include "render/gl/render_target.h"

#include "render/gl/draw_state.h"

namespace prairie {
namespace {

constexpr int kSamples = 4;

GlTexture make_surface(glm::ivec2 size_px, GLenum format, bool msaa, const char* label) {
  GlTexture texture = make_texture(msaa ? GL_TEXTURE_2D_MULTISAMPLE : GL_TEXTURE_2D, label);
  if (msaa) {
    glTextureStorage2DMultisample(texture.get(), kSamples, format, size_px.x, size_px.y, GL_TRUE);
  } else {
    glTextureStorage2D(texture.get(), 1, format, size_px.x, size_px.y);
  }
  return texture;
}

}  // namespace

RenderTarget::RenderTarget(glm::ivec2 size_px, bool msaa)
    : size_px_(size_px),
      msaa_(msaa),
      color_(make_surface(size_px, GL_RGBA16F, msaa, "frame color")),
      depth_(make_surface(size_px, GL_DEPTH_COMPONENT32F, msaa, "frame depth")),
      framebuffer_(make_framebuffer("frame")) {
  glNamedFramebufferTexture(framebuffer_.get(), GL_COLOR_ATTACHMENT0, color_.get(), 0);
  glNamedFramebufferTexture(framebuffer_.get(), GL_DEPTH_ATTACHMENT, depth_.get(), 0);
  if (msaa_) {
    resolved_color_ = make_surface(size_px, GL_RGBA16F, false, "resolved frame color");
    resolved_framebuffer_ = make_framebuffer("resolved frame");
    glNamedFramebufferTexture(resolved_framebuffer_.get(), GL_COLOR_ATTACHMENT0, resolved_color_.get(), 0);
  }
}

void RenderTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
  glViewport(0, 0, size_px_.x, size_px_.y);
  set_draw_state({});  // clearing goes by it, too
  const float black[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  const float far = 0.0f;
  glClearNamedFramebufferfv(framebuffer_.get(), GL_COLOR, 0, black);
  glClearNamedFramebufferfv(framebuffer_.get(), GL_DEPTH, 0, &far);
}

GLuint RenderTarget::resolved_framebuffer() const {
  if (!msaa_) return framebuffer_.get();
  glBlitNamedFramebuffer(framebuffer_.get(), resolved_framebuffer_.get(), 0, 0, size_px_.x, size_px_.y, 0, 0,
                         size_px_.x, size_px_.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  return resolved_framebuffer_.get();
}

GLuint RenderTarget::resolved() const {
  resolved_framebuffer();
  return msaa_ ? resolved_color_.get() : color_.get();
}

}  // namespace prairie
