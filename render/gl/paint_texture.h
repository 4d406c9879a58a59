// Textures that a fragment shader paints, once or whenever what they show changes.
#pragma once

#include <epoxy/gl.h>

#include <glm/vec2.hpp>
#include <initializer_list>

namespace prairie {

/// What is painted: a texture's finest level, of an array one of its layers.
struct PaintedImage {
  GLuint texture = 0;
  GLint layer = kWhole;

  static constexpr GLint kWhole = -1;
};

/// Runs a program with shaders/pass/screen.vert for every texel; output n of its fragment shader goes to
/// image n. All images are of that size. Drawing goes on afterwards into what was drawn into before; mipmaps
/// are the caller's.
void paint_texture(GLuint program, std::initializer_list<PaintedImage> images, glm::ivec2 size_px);

}  // namespace prairie
