// The figure of a walker, generated: a clothed body of lofted parts (jacket, trousers, sleeves, hands, shoes,
// neck and head), each a closed tube through oval rings whose sizes are interpolated smoothly (Catmull-Rom)
// between those given. Parts reach into one another where clothes do, so that no joint of the skeleton is on
// a seam. Its proportions are those of agents/skeleton.h.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace prairie {

struct WalkerVertex {
  glm::vec3 place_m;  // of the resting figure
  float openness;     // share of the sky that other parts of the figure leave free
  glm::vec3 facing;   // unit normal
  std::array<std::uint8_t, 4>
      skinning;  // two joints, 255ths of the second's weight, material (shaders/shared/walker.glsl)
};

struct WalkerMesh {
  std::vector<WalkerVertex> vertices;
  std::vector<std::uint16_t> indices;  // of triangles, counter-clockwise from outside
};

/// Levels of detail: about 7500, 1400 and 300 triangles.
inline constexpr std::size_t kWalkerLevels = 3;
WalkerMesh walker_mesh(std::size_t level);

}  // namespace prairie
