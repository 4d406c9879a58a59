#include "render/gl/paint_texture.h"

#include <array>
#include <vector>

#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/screen_triangle.h"

namespace prairie {

void paint_texture(GLuint program, std::initializer_list<PaintedImage> images, glm::ivec2 size_px) {
  GLint bound = 0;
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport.data());

  const GlFramebuffer framebuffer = make_framebuffer("painted texture");
  std::vector<GLenum> outputs;
  for (const PaintedImage& image : images) {
    const GLenum output = GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(outputs.size());
    if (image.layer == PaintedImage::kWhole) {
      glNamedFramebufferTexture(framebuffer.get(), output, image.texture, 0);
    } else {
      glNamedFramebufferTextureLayer(framebuffer.get(), output, image.texture, 0, image.layer);
    }
    outputs.push_back(output);
  }
  glNamedFramebufferDrawBuffers(framebuffer.get(), static_cast<GLsizei>(outputs.size()), outputs.data());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.get());
  glViewport(0, 0, size_px.x, size_px.y);
  set_draw_state(kOverAll);
  glUseProgram(program);
  ScreenTriangle().draw();

  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

}  // namespace prairie
