#include "render/post/develop.h"

#include "render/gl/draw_state.h"
#include "render/gl/shader_program.h"
#include "shaders/shared/layouts.h"

namespace prairie {

Develop::Develop(const std::filesystem::path& shader_folder)
    : program_(make_program(shader_folder, {"pass/screen.vert", "pass/tone.frag"})) {}

void Develop::draw(GLuint linear_texture, GLuint framebuffer, glm::ivec2 size_px, float exposure) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, size_px.x, size_px.y);
  set_draw_state(kOverAll);
  glUseProgram(program_.get());
  glProgramUniform1f(program_.get(), layouts::kToneExposure, exposure);
  glBindTextureUnit(layouts::kLinearPictureUnit, linear_texture);
  triangle_.draw();
}

}  // namespace prairie
