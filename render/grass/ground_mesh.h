// The mesh of a ground patch as numbers: vertices sampled from the height field, triangles whose edges
// towards coarser neighbours leave out every other vertex, so that no crack can open.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "generator/meadow.h"
#include "lod/frame_plan.h"

namespace prairie {

inline constexpr std::uint32_t kGroundSide = kPatchQuads + 1;  // vertices along a side
inline constexpr std::uint32_t kGroundVertices = kGroundSide * kGroundSide;

struct GroundVertex {
  float height_m = 0.0f;  // above the anchor
  std::array<std::int16_t, 4> normal{};
};
static_assert(sizeof(GroundVertex) == 12);

/// Where the mesh's frame has its origin for this eye: whole multiples of the coarsest quad near it, at a
/// fixed height.
glm::dvec3 ground_anchor_m(const Meadow& meadow, glm::dvec3 eye_m);

/// Row by row from south.
std::array<GroundVertex, kGroundVertices> patch_vertices(const Meadow& meadow, const GroundPatch& patch);

/// Corners of triangles; along a side whose neighbour is coarser (PatchSide bits), odd vertices move to the
/// even one before them.
std::vector<std::uint16_t> patch_indices(std::uint8_t coarser_sides);

}  // namespace prairie
