#include "render/things/obstacle_texture.h"

#include <array>
#include <bit>
#include <cassert>

#include "render/gl/paint_texture.h"
#include "render/gl/shader_program.h"
#include "render/things/shapes/obstacle_material.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = 512;        // 2 or 3 mm a texel
constexpr int kReliefPlaces = 7;  // that a texel is found from
constexpr std::array<const char*, kObstacleMaterials> kDefines{"BARK", "END_GRAIN", "GRANITE", "BOARDS",
                                                               "DRY_STONE"};

GlTexture make_layers(const char* label) {
  GlTexture texture = make_texture(GL_TEXTURE_2D_ARRAY, label);
  glTextureStorage3D(texture.get(), std::bit_width(static_cast<unsigned>(kSide)), GL_RGBA8, kSide, kSide,
                     static_cast<GLsizei>(kObstacleMaterials));
  set_sampling(texture, {.minified = GL_LINEAR_MIPMAP_NEAREST, .magnified = GL_LINEAR, .wrap = GL_REPEAT});
  return texture;
}

}  // namespace

ObstacleTexture paint_obstacle_texture(const std::filesystem::path& shader_folder,
                                       std::span<const bool> materials) {
  assert(materials.size() == kObstacleMaterials);
  ObstacleTexture texture{make_layers("obstacle albedo"), make_layers("obstacle surface")};
  for (std::size_t layer = 0; layer < kObstacleMaterials; ++layer) {
    if (!materials[layer]) continue;
    const GlProgram program =
        make_program(shader_folder, {"pass/screen.vert", "pass/obstacle_texture.frag"}, {kDefines[layer]});
    glProgramUniform1f(program.get(), layouts::kObstacleTexels, static_cast<float>(kSide));
    glProgramUniform1i(program.get(), layouts::kObstaclePlaces, kReliefPlaces);
    const auto z = static_cast<GLint>(layer);
    paint_texture(program.get(), {{texture.albedo.get(), z}, {texture.surface.get(), z}}, {kSide, kSide});
  }
  glGenerateTextureMipmap(texture.albedo.get());
  glGenerateTextureMipmap(texture.surface.get());
  return texture;
}

}  // namespace prairie
