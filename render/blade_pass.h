// Draws the plan's 3D blades: plants and poses them in batches (one compute dispatch each), then draws each
// batch group by group of equal segment count.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

#include "lod/frame_plan.h"
#include "render/compute_batch.h"
#include "render/gl_objects.h"
#include "world/world.h"

namespace prairie {

class BladePass {
 public:
  BladePass(const World& world, const std::filesystem::path& shader_folder);

  /// The frame block must be bound.
  void draw(const FramePlan& plan);
  std::uint64_t triangles_drawn() const { return triangles_drawn_; }

 private:
  GLuint indices_for(std::uint32_t segments);

  const World* world_;
  GlProgram pose_program_;
  GlProgram draw_program_;
  GlVertexArray vertex_array_;
  ComputeBatch batch_;
  GlBuffer posed_;
  GlTexture posed_texels_;  // of the same memory
  std::vector<SpeciesParams> species_;
  std::map<std::uint32_t, GlBuffer> indices_;  // by segments
  std::uint64_t triangles_drawn_ = 0;
};

}  // namespace prairie
