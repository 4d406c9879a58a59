// The meshes of solid things, one for each shape, within the cube from −1 to 1.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace prairie {

struct SolidVertex {
  glm::vec3 place;   // shares of the half size; of a box its corner, not yet rounded
  glm::vec3 facing;  // unit normal
};

struct SolidMesh {
  std::vector<SolidVertex> vertices;
  std::vector<std::uint16_t> indices;  // of triangles
};

/// The unit sphere as an icosahedron, each triangle cut into four `subdivisions` times; all vertices lie on
/// the sphere.
SolidMesh sphere_mesh(int subdivisions);

/// A cube whose edges and corners can be rounded: its vertices are place · (half size − radius) + radius ·
/// facing.
SolidMesh box_mesh();

/// A wheel around the y axis: rim, hub, and two discs between them that hold the spokes.
SolidMesh wheel_mesh();

}  // namespace prairie
