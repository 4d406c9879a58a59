#include "render/gl/vertex_layout.h"

namespace prairie {
namespace {

constexpr GLuint kVertexBinding = 0;

}  // namespace

GlVertexArray make_vertex_array(std::span<const VertexAttribute> attributes, const char* label) {
  GlVertexArray array = make_vertex_array(label);
  for (GLuint location = 0; location < attributes.size(); ++location) {
    const VertexAttribute& attribute = attributes[location];
    const auto offset = static_cast<GLuint>(attribute.offset);
    glEnableVertexArrayAttrib(array.get(), location);
    if (attribute.numbers == Numbers::kIntegers) {
      glVertexArrayAttribIFormat(array.get(), location, attribute.components, attribute.type, offset);
    } else {
      const GLboolean normalized = attribute.numbers == Numbers::kNormalized ? GL_TRUE : GL_FALSE;
      glVertexArrayAttribFormat(array.get(), location, attribute.components, attribute.type, normalized,
                                offset);
    }
    glVertexArrayAttribBinding(array.get(), location, kVertexBinding);
  }
  return array;
}

void set_vertices(const GlVertexArray& array, const GlBuffer& vertices, std::size_t stride) {
  glVertexArrayVertexBuffer(array.get(), kVertexBinding, vertices.get(), 0, static_cast<GLsizei>(stride));
}

}  // namespace prairie
