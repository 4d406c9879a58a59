// From a linear picture to one that a screen shows: exposure, tone curve, sRGB (shaders/pass/tone.frag).
#pragma once

#include <filesystem>
#include <glm/vec2.hpp>

#include "render/gl/gl_objects.h"
#include "render/gl/screen_triangle.h"

namespace prairie {

class Develop {
 public:
  explicit Develop(const std::filesystem::path& shader_folder);

  /// Draws the texture into a framebuffer (0: the window) of its size.
  void draw(GLuint linear_texture, GLuint framebuffer, glm::ivec2 size_px, float exposure) const;

 private:
  GlProgram program_;
  ScreenTriangle triangle_;
};

}  // namespace prairie
