#include "render/stone_map.h"

#include <array>
#include <bit>
#include <glm/mat3x3.hpp>

#include "render/shader_program.h"

namespace prairie {
namespace {

constexpr int kSide = 256;  // 3 mm a texel on a stone of 0.45 m
constexpr int kFaces = 6;

// Columns: what goes right, up and out of a face, as OpenGL lays cube maps.
constexpr std::array<std::array<glm::vec3, 3>, kFaces> kBodyFromFace{{
    {{{0, 0, -1}, {0, -1, 0}, {1, 0, 0}}},
    {{{0, 0, 1}, {0, -1, 0}, {-1, 0, 0}}},
    {{{1, 0, 0}, {0, 0, 1}, {0, 1, 0}}},
    {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}},
    {{{1, 0, 0}, {0, -1, 0}, {0, 0, 1}}},
    {{{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}}},
}};

GlTexture make_cube_map() {
  GlTexture texture = make_texture(GL_TEXTURE_CUBE_MAP);
  glTextureStorage2D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_RGBA8, kSide, kSide);
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  return texture;
}

}  // namespace

StoneMap paint_stone_map(const std::filesystem::path& shader_folder, glm::vec3 mean_albedo) {
  const GlProgram program = make_program(shader_folder, {"pass/screen.vert", "pass/stone_map.frag"});
  const GlVertexArray no_vertices = make_vertex_array();
  StoneMap map{make_cube_map(), make_cube_map()};
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glUseProgram(program.get());
  glBindVertexArray(no_vertices.get());
  glProgramUniform1f(program.get(), 3, static_cast<float>(kSide));
  glProgramUniform3fv(program.get(), 4, 1, &mean_albedo[0]);
  for (int face = 0; face < kFaces; ++face) {
    const GlFramebuffer framebuffer = make_framebuffer();
    glNamedFramebufferTextureLayer(framebuffer.get(), GL_COLOR_ATTACHMENT0, map.albedo.get(), 0, face);
    glNamedFramebufferTextureLayer(framebuffer.get(), GL_COLOR_ATTACHMENT1, map.surface.get(), 0, face);
    const std::array<GLenum, 2> targets{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
    glNamedFramebufferDrawBuffers(framebuffer.get(), static_cast<GLsizei>(targets.size()), targets.data());
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
    glViewport(0, 0, kSide, kSide);
    const auto& columns = kBodyFromFace[static_cast<std::size_t>(face)];
    const glm::mat3 body_from_face(columns[0], columns[1], columns[2]);
    glProgramUniformMatrix3fv(program.get(), 0, 1, GL_FALSE, &body_from_face[0][0]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
  }
  glGenerateTextureMipmap(map.albedo.get());
  glGenerateTextureMipmap(map.surface.get());
  return map;
}

}  // namespace prairie
