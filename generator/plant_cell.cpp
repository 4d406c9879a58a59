#include "generator/plant_cell.h"

#include <algorithm>
#include <cstdint>

#include "generator/vector_stage.h"
#include "shaders/kernels/kernels.h"

// The kernels are planted in stages over short blocks, each stage's results in arrays of their own, so that
// the compiler plants 4 or 8 blades with one instruction (generator/vector_stage.h); the results are those of
// Kernels::plant_blade, bit for bit.
namespace prairie {
namespace {

constexpr std::uint32_t kBlock = 64;

struct Roots {
  float point_x[kBlock];
  float point_y[kBlock];
  float x_m[kBlock];
  float y_m[kBlock];
  float ground_m[kBlock];
};

struct TraitBlock {
  float height[kBlock];
  float width[kBlock];
  float azimuth[kBlock];
  float tilt[kBlock];
  float curvature[kBlock];
  float hue[kBlock];
  float dryness[kBlock];
  float stiffness[kBlock];
  float phase[kBlock];
  float lean_x[kBlock];
  float lean_y[kBlock];
};

struct ClumpBlock {
  float height[kBlock];
  float hue[kBlock];
  float dryness[kBlock];
  float lean_x[kBlock];
  float lean_y[kBlock];
  float outward_x[kBlock];
  float outward_y[kBlock];
};

PRAIRIE_VECTOR_STAGE void draw_points(const PlantedCell& cell, std::uint32_t first, Roots& __restrict roots) {
  for (std::uint32_t n = 0; n < kBlock; ++n) {
    const glm::vec2 point = Kernels{}.sequence_point(first + n, cell.key.x);
    roots.point_x[n] = point.x;
    roots.point_y[n] = point.y;
  }
}

PRAIRIE_VECTOR_STAGE void warp_points(const PlantedCell& cell, const float* __restrict tables,
                                      Roots& __restrict roots) {
  Kernels kernels{tables};
  for (std::uint32_t n = 0; n < kBlock; ++n) {
    const glm::vec2 local_m = kernels.root_in_cell(
        cell,
        kernels.warp_to_density(cell.density_table, cell.patches, {roots.point_x[n], roots.point_y[n]}));
    roots.x_m[n] = local_m.x;
    roots.y_m[n] = local_m.y;
  }
}

PRAIRIE_VECTOR_STAGE void find_ground(const PlantedCell& cell, const float* __restrict tables,
                                      Roots& __restrict roots) {
  Kernels kernels{tables};
  for (std::uint32_t n = 0; n < kBlock; ++n) {
    roots.ground_m[n] =
        kernels.ground_in_cell(cell.ground_table, cell.side_m, {roots.x_m[n], roots.y_m[n]}).height_m;
  }
}

PRAIRIE_VECTOR_STAGE void draw_traits(const PlantedCell& cell, std::uint32_t first,
                                      TraitBlock& __restrict block) {
  for (std::uint32_t n = 0; n < kBlock; ++n) {
    const Kernels::Traits traits = Kernels{}.traits_of(cell.key.y, first + n);
    block.height[n] = traits.height;
    block.width[n] = traits.width;
    block.azimuth[n] = traits.azimuth;
    block.tilt[n] = traits.tilt;
    block.curvature[n] = traits.curvature;
    block.hue[n] = traits.hue;
    block.dryness[n] = traits.dryness;
    block.stiffness[n] = traits.stiffness;
    block.phase[n] = traits.phase;
    block.lean_x[n] = traits.lean.x;
    block.lean_y[n] = traits.lean.y;
  }
}

PRAIRIE_VECTOR_STAGE void find_clumps(const PlantedCell& cell, const SpeciesParams& species,
                                      const Roots& __restrict roots, ClumpBlock& __restrict block) {
  for (std::uint32_t n = 0; n < kBlock; ++n) {
    const Kernels::Clump clump = Kernels{}.clump_of(cell, species, {roots.x_m[n], roots.y_m[n]});
    block.height[n] = clump.height;
    block.hue[n] = clump.hue;
    block.dryness[n] = clump.dryness;
    block.lean_x[n] = clump.lean.x;
    block.lean_y[n] = clump.lean.y;
    block.outward_x[n] = clump.outward.x;
    block.outward_y[n] = clump.outward.y;
  }
}

Kernels::Traits traits_at(const TraitBlock& block, std::uint32_t n) {
  return {block.height[n],    block.width[n],
          block.azimuth[n],   block.tilt[n],
          block.curvature[n], block.hue[n],
          block.dryness[n],   block.stiffness[n],
          block.phase[n],     {block.lean_x[n], block.lean_y[n]}};
}

Kernels::Clump clump_at(const ClumpBlock& block, std::uint32_t n) {
  return {block.height[n],
          block.hue[n],
          block.dryness[n],
          {block.lean_x[n], block.lean_y[n]},
          {block.outward_x[n], block.outward_y[n]}};
}

}  // namespace

void plant_cell(const PlantedCell& cell, const SpeciesParams& species, std::span<const float> tables,
                std::span<Blade> out) {
  Kernels kernels{tables.data()};
  Roots roots;
  TraitBlock traits;
  ClumpBlock clumps;
  for (std::uint32_t first = 0; first < out.size(); first += kBlock) {
    draw_points(cell, first, roots);
    warp_points(cell, tables.data(), roots);
    find_ground(cell, tables.data(), roots);
    draw_traits(cell, first, traits);
    find_clumps(cell, species, roots, clumps);
    const std::uint32_t count =
        std::min<std::uint32_t>(kBlock, static_cast<std::uint32_t>(out.size()) - first);
    for (std::uint32_t n = 0; n < count; ++n) {
      const glm::vec2 local_m(roots.x_m[n], roots.y_m[n]);
      out[first + n] =
          kernels.grow_blade(cell, species, first + n, local_m, traits_at(traits, n), clump_at(clumps, n),
                             kernels.features_of(cell, local_m), roots.ground_m[n]);
    }
  }
}

}  // namespace prairie
