#include "render/things/stone_map.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr int kSide = 512;  // about 4 mm a texel on a stone of 0.45 m
constexpr GLenum kFormat = GL_RGBA8;
constexpr GLsizei kLevels = std::bit_width(static_cast<unsigned>(kSide));

GlTexture make_map() {
  GlTexture texture = make_texture(GL_TEXTURE_2D);
  glTextureStorage2D(texture.get(), kLevels, kFormat, kSide, kSide);
  return texture;
}

GlTexture level_of(const GlTexture& map, GLuint level) {
  GLuint name = 0;
  glGenTextures(1, &name);  // a view must not have been given a target before
  glTextureView(name, GL_TEXTURE_2D, map.get(), kFormat, level, 1, 0, 1);
  glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return GlTexture(name);
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
  const GlTexture albedo = make_map(), surface = make_map();
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT0, albedo.get(), 0);
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT1, surface.get(), 0);
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
  glGenerateTextureMipmap(albedo.get());
  glGenerateTextureMipmap(surface.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glEnable(GL_DEPTH_TEST);
  StoneMap map;
  for (GLuint level = 0; level < kLevels; ++level)
    map.levels.push_back({level_of(albedo, level), level_of(surface, level)});
  return map;
}

std::size_t StoneMap::level_for(double radius_m, double pixel_m) const {
  const double level = std::log2(std::max(0.25 * pixel_m / radius_m * kSide, 1e-3));
  return static_cast<std::size_t>(std::clamp(std::lround(level), 0l, static_cast<long>(levels.size()) - 1));
}

}  // namespace prairie
