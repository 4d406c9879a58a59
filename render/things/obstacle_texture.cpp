#include "render/things/obstacle_texture.h"

#include <array>
#include <bit>
#include <cassert>

#include "render/gl/shader_program.h"
#include "render/things/shapes/obstacle_material.h"

namespace prairie {
namespace {

constexpr int kSide = 512;        // 2 or 3 mm a texel
constexpr int kReliefPlaces = 7;  // that a texel is found from
constexpr std::array<const char*, kObstacleMaterials> kDefines{"BARK", "END_GRAIN", "GRANITE", "BOARDS",
                                                               "DRY_STONE"};

GlTexture make_layers() {
  GlTexture texture = make_texture(GL_TEXTURE_2D_ARRAY);
  glTextureStorage3D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_RGBA8, kSide, kSide,
                     static_cast<GLsizei>(kObstacleMaterials));
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, GL_REPEAT);
  return texture;
}

}  // namespace

ObstacleTexture paint_obstacle_texture(const std::filesystem::path& shader_folder,
                                       std::span<const bool> materials) {
  assert(materials.size() == kObstacleMaterials);
  const GlVertexArray no_vertices = make_vertex_array();
  const GlFramebuffer framebuffer = make_framebuffer();
  GLint bound = 0;
  std::array<GLint, 4> viewport{};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport.data());
  ObstacleTexture texture{make_layers(), make_layers()};
  const std::array<GLenum, 2> targets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glNamedFramebufferDrawBuffers(framebuffer.get(), static_cast<GLsizei>(targets.size()), targets.data());
  glViewport(0, 0, kSide, kSide);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glBindVertexArray(no_vertices.get());
  for (std::size_t layer = 0; layer < kObstacleMaterials; ++layer) {
    if (!materials[layer]) continue;
    const GlProgram program =
        make_program(shader_folder, {"pass/screen.vert", "pass/obstacle_texture.frag"}, {kDefines[layer]});
    const auto z = static_cast<GLint>(layer);
    glNamedFramebufferTextureLayer(framebuffer.get(), GL_COLOR_ATTACHMENT0, texture.albedo.get(), 0, z);
    glNamedFramebufferTextureLayer(framebuffer.get(), GL_COLOR_ATTACHMENT1, texture.surface.get(), 0, z);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer.get());
    glUseProgram(program.get());
    glProgramUniform1f(program.get(), 0, static_cast<float>(kSide));
    glProgramUniform1i(program.get(), 1, kReliefPlaces);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glGenerateTextureMipmap(texture.albedo.get());
  glGenerateTextureMipmap(texture.surface.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(bound));
  glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
  glEnable(GL_DEPTH_TEST);
  return texture;
}

}  // namespace prairie
