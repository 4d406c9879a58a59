#include "render/stone_map.h"

#include <array>
#include <bit>

#include "render/shader_program.h"

namespace prairie {
namespace {

constexpr int kSide = 512;  // about 4 mm a texel on a stone of 0.45 m

GlTexture make_map() {
  GlTexture texture = make_texture(GL_TEXTURE_2D);
  glTextureStorage2D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_RGBA8, kSide, kSide);
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

StoneMap paint_stone_map(const std::filesystem::path& shader_folder, glm::vec3 mean_albedo) {
  const GlProgram program = make_program(shader_folder, {"pass/screen.vert", "pass/stone_map.frag"});
  const GlVertexArray no_vertices = make_vertex_array();
  const GlFramebuffer framebuffer = make_framebuffer();
  GLint bound = 0;
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  StoneMap map{make_map(), make_map()};
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT0, map.albedo.get(), 0);
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT1, map.surface.get(), 0);
  const std::array<GLenum, 2> targets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(framebuffer.get(), static_cast<GLsizei>(targets.size()), targets.data());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.get());
  glViewport(0, 0, kSide, kSide);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(program.get());
  glBindVertexArray(no_vertices.get());
  glProgramUniform1f(program.get(), 0, static_cast<float>(kSide));
  glProgramUniform3fv(program.get(), 1, 1, &mean_albedo[0]);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glGenerateTextureMipmap(map.albedo.get());
  glGenerateTextureMipmap(map.surface.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glEnable(GL_DEPTH_TEST);
  return map;
}

}  // namespace prairie
