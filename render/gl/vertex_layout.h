// How the vertices of a mesh lie in their buffer, told once for each kind of vertex.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <span>

#include "render/gl/gl_objects.h"

namespace prairie {

/// How shaders see the numbers of an attribute.
enum class Numbers { kAsTheyAre, kNormalized, kIntegers };

/// One input of a vertex shader; its location is its place in the list.
struct VertexAttribute {
  GLint components = 1;
  GLenum type = GL_FLOAT;
  std::size_t offset = 0;
  Numbers numbers = Numbers::kAsTheyAre;
};

/// A vertex array whose attributes lie so in one buffer, which `set_vertices` names.
GlVertexArray make_vertex_array(std::span<const VertexAttribute> attributes, const char* label);
/// Vertices of `stride` bytes come from this buffer.
void set_vertices(const GlVertexArray& array, const GlBuffer& vertices, std::size_t stride);

}  // namespace prairie
