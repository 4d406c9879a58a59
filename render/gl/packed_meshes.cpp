#include "render/gl/packed_meshes.h"

namespace prairie {

std::uint64_t PackedMeshes::draw(std::size_t mesh, std::uint32_t instances) const {
  const Part& part = parts_[mesh];
  glBindVertexArray(array_.get());
  glDrawElementsInstancedBaseVertex(GL_TRIANGLES, part.indices, GL_UNSIGNED_SHORT,
                                    reinterpret_cast<const void*>(part.first_index_byte),
                                    static_cast<GLsizei>(instances), part.base_vertex);
  return std::uint64_t{instances} * static_cast<std::uint64_t>(part.indices) / 3;
}

}  // namespace prairie
