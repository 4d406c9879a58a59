#include "render/light/sky_pass.h"

#include <cmath>
#include <glm/mat3x3.hpp>

#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr int kMapSide = 1024;

glm::mat3 view_directions(const Camera& camera) {
  const double half = std::tan(0.5 * camera.fov_rad);
  const double aspect = static_cast<double>(camera.size_px.x) / camera.size_px.y;
  return {glm::vec3(camera.right() * half * aspect), glm::vec3(camera.up() * half),
          glm::vec3(camera.forward())};
}

}  // namespace

SkyPass::SkyPass(const std::filesystem::path& shader_folder)
    : map_program_(make_program(shader_folder, {"pass/screen.vert", "pass/sky_map.frag"})),
      draw_program_(make_program(shader_folder, {"pass/screen.vert", "pass/sky.frag"})),
      no_vertices_(make_vertex_array()),
      map_(make_texture(GL_TEXTURE_2D)) {
  glTextureStorage2D(map_.get(), 1, GL_RGBA16F, kMapSide, kMapSide);
  glTextureParameteri(map_.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(map_.get(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(map_.get(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

void SkyPass::set_light() {
  GlFramebuffer framebuffer = make_framebuffer();
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT0, map_.get(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glViewport(0, 0, kMapSide, kMapSide);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(map_program_.get());
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SkyPass::draw(const Camera& camera) {
  const glm::mat3 scene_from_view = view_directions(camera);
  glUseProgram(draw_program_.get());
  glProgramUniformMatrix3fv(draw_program_.get(), 0, 1, GL_FALSE, &scene_from_view[0][0]);
  glBindTextureUnit(0, map_.get());
  glBindVertexArray(no_vertices_.get());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace prairie
