#include "render/things/stone_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/gl/paint_texture.h"
#include "render/gl/shader_program.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr int kSide = 512;  // about 4 mm a texel on a stone of 0.45 m
constexpr GLenum kFormat = GL_RGBA8;
constexpr GLsizei kLevels = std::bit_width(static_cast<unsigned>(kSide));

GlTexture make_map(const char* label) {
  GlTexture texture = make_texture(GL_TEXTURE_2D, label);
  glTextureStorage2D(texture.get(), kLevels, kFormat, kSide, kSide);
  return texture;
}

GlTexture level_of(const GlTexture& map, GLuint level) {
  GLuint name = 0;
  glGenTextures(1, &name);  // a view must not have been given a target before
  glTextureView(name, GL_TEXTURE_2D, map.get(), kFormat, level, 1, 0, 1);
  GlTexture texture(name);
  set_sampling(texture, {.minified = GL_LINEAR, .magnified = GL_LINEAR, .wrap = GL_CLAMP_TO_EDGE});
  return texture;
}

}  // namespace

StoneMap paint_stone_map(const std::filesystem::path& shader_folder, glm::vec3 mean_albedo) {
  const GlProgram program = make_program(shader_folder, {"pass/screen.vert", "pass/stone_map.frag"});
  glProgramUniform1f(program.get(), layouts::kStoneTexels, static_cast<float>(kSide));
  glProgramUniform3fv(program.get(), layouts::kStoneAlbedo, 1, &mean_albedo[0]);
  const GlTexture albedo = make_map("stone albedo"), surface = make_map("stone surface");
  paint_texture(program.get(), {{albedo.get()}, {surface.get()}}, {kSide, kSide});
  glGenerateTextureMipmap(albedo.get());
  glGenerateTextureMipmap(surface.get());
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
