// Draws the ground (G03 §3.5): patches of the plan (render/grass/ground_mesh.h), which are kept on the device
// while they are used.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <unordered_map>
#include <vector>

#include "generator/meadow.h"
#include "lod/frame_plan.h"
#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/grass/moving_program.h"

namespace prairie {

class GroundPass {
 public:
  static constexpr DrawState kState{};

  /// `blade_area_from_above_m2`: of each species (lod/sward/field_look.h). The meadow has to outlive the
  /// pass.
  GroundPass(const Meadow& meadow, const std::filesystem::path& shader_folder,
             std::span<const double> blade_area_from_above_m2);

  /// The frame's blocks must be bound, and for any variant but the plain one the moving fields.
  void draw(const FramePlan& plan, GrassVariant variant);
  /// Size of the flat tier's texture in the scene.
  glm::dvec2 flat_period_m() const { return flat_period_m_; }
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  struct Slot {
    std::uint32_t index = 0;
    std::uint64_t last_frame = 0;
  };
  std::uint32_t slot_of(const GroundPatch& patch);
  void fill_slot(std::uint32_t slot, const GroundPatch& patch);
  void upload_morphs(const FramePlan& plan);

  const Meadow* meadow_;
  MovingProgram program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_{"ground vertices"};
  GlBuffer indices_{"ground indices"};
  GlBuffer patch_params_{"ground patches"};
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
