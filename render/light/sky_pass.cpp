#include "render/light/sky_pass.h"

#include <cmath>
#include <glm/mat3x3.hpp>

#include "render/gl/paint_texture.h"
#include "render/gl/shader_program.h"
#include "shaders/shared/layouts.h"

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
    : program_(make_program(shader_folder, {"pass/screen.vert", "pass/sky.frag"})),
      map_(make_texture(GL_TEXTURE_2D, "sky map")) {
  glTextureStorage2D(map_.get(), 1, GL_RGBA16F, kMapSide, kMapSide);
  set_sampling(map_, {.minified = GL_LINEAR, .magnified = GL_LINEAR, .wrap = GL_CLAMP_TO_EDGE});
  const GlProgram map_program = make_program(shader_folder, {"pass/screen.vert", "pass/sky_map.frag"});
  paint_texture(map_program.get(), {{map_.get()}}, {kMapSide, kMapSide});
}

void SkyPass::draw(const Camera& camera) {
  const glm::mat3 scene_from_view = view_directions(camera);
  glUseProgram(program_.get());
  glProgramUniformMatrix3fv(program_.get(), layouts::kSkyDirections, 1, GL_FALSE, &scene_from_view[0][0]);
  glBindTextureUnit(layouts::kSkyMapUnit, map_.get());
  triangle_.draw();
}

}  // namespace prairie
