// Several meshes of one kind of vertex in one pair of buffers, drawn by their place in the list.
#pragma once

#include <epoxy/gl.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/vertex_layout.h"

namespace prairie {

class PackedMeshes {
 public:
  /// `meshes`: each with `vertices` and `indices` (16 bits, of triangles).
  template <class Mesh>
  PackedMeshes(std::span<const Mesh> meshes, std::span<const VertexAttribute> attributes, const char* label)
      : vertices_(label), indices_(label), array_(make_vertex_array(attributes, label)) {
    auto vertices = meshes.front().vertices;
    vertices.clear();
    std::vector<std::uint16_t> indices;
    for (const Mesh& mesh : meshes) {
      parts_.push_back({indices.size() * sizeof(std::uint16_t), static_cast<GLsizei>(mesh.indices.size()),
                        static_cast<GLint>(vertices.size())});
      vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
      indices.insert(indices.end(), mesh.indices.begin(), mesh.indices.end());
    }
    vertices_.upload(vertices.data(), vertices.size() * sizeof(vertices.front()));
    indices_.upload(std::span<const std::uint16_t>(indices));
    set_vertices(array_, vertices_, sizeof(vertices.front()));
    glVertexArrayElementBuffer(array_.get(), indices_.get());
  }

  /// Draws a mesh so many times with the program in use; returns the number of triangles.
  std::uint64_t draw(std::size_t mesh, std::uint32_t instances) const;

 private:
  struct Part {
    std::size_t first_index_byte = 0;
    GLsizei indices = 0;
    GLint base_vertex = 0;
  };

  GlBuffer vertices_;
  GlBuffer indices_;
  GlVertexArray array_;
  std::vector<Part> parts_;
};

}  // namespace prairie
