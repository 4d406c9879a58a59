// Draws the sky behind everything, from a map that is made once per light.
#pragma once

#include <filesystem>

#include "lod/camera.h"
#include "render/gl/gl_objects.h"

namespace prairie {

class SkyPass {
 public:
  explicit SkyPass(const std::filesystem::path& shader_folder);

  /// Makes the map for the bound frame block's light. The noise texture must be bound.
  void set_light();
  void draw(const Camera& camera);

 private:
  GlProgram map_program_;
  GlProgram draw_program_;
  GlVertexArray no_vertices_;
  GlTexture map_;
};

}  // namespace prairie
