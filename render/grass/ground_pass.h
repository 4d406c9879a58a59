// Draws the ground: patches of the plan, their vertices sampled from the height field once and kept while
// they are used, edges towards coarser neighbours stitched by leaving out every other vertex, so that no
// crack can open.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <unordered_map>
#include <vector>

#include "lod/frame_plan.h"
#include "render/gl/gl_objects.h"
#include "render/grass/moving_program.h"
#include "render/light/light.h"
#include "world/world.h"

namespace prairie {

class GroundPass {
 public:
  /// `blade_area_from_above_m2`: of each species (render/grass/sward_tables.h).
  GroundPass(const World& world, const std::filesystem::path& shader_folder,
             std::span<const double> blade_area_from_above_m2);

  /// The frame block must be bound, and for any variant but the plain one the moving fields. `anchor_m`: as
  /// in it.
  void draw(const FramePlan& plan, glm::dvec3 anchor_m, GrassVariant variant);
  /// Where the mesh's frame has its origin for this eye: whole multiples of the coarsest quad near it, at a
  /// fixed height.
  glm::dvec3 anchor_m(glm::dvec3 eye_m) const;
  /// What the frame block tells of the ground for this eye.
  GroundLook look(glm::dvec3 eye_m) const { return {anchor_m(eye_m), flat_period_m_}; }
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  struct Slot {
    std::uint32_t index = 0;
    std::uint64_t last_frame = 0;
  };
  std::uint32_t slot_of(const GroundPatch& patch);
  void fill_slot(std::uint32_t slot, const GroundPatch& patch);
  void upload_morphs(const FramePlan& plan);

  const World* world_;
  MovingProgram program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_;
  GlBuffer indices_;
  GlBuffer patch_params_;
  GlTexture flat_map_;
  GlTexture tile_morphs_;
  std::vector<std::uint8_t> morph_steps_;
  glm::dvec2 flat_period_m_{1.0};
  struct IndexRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  std::array<IndexRange, 16> index_ranges_;  // by GroundPatch::coarser_sides
  std::unordered_map<std::uint64_t, Slot> slots_;
  std::vector<std::uint32_t> free_slots_;
  std::uint64_t frame_ = 0;
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace prairie
