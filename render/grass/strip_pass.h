// Draws the plan's strips (G03 §3.4): a compute shader lays them along the tiles' sides and paints them, an
// alpha test shows as many blades of the texture as the density asks for.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lod/frame_plan.h"
#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/gl/texel_view.h"
#include "render/grass/moving_program.h"
#include "render/grass/strip_painter.h"

namespace prairie {

class StripPass {
 public:
  static constexpr DrawState kState{};

  /// `texture`: of the field's species (render/grass/strip_painter.h).
  StripPass(const std::filesystem::path& shader_folder, StripTexture texture);

  /// Lays the plan's strips; whether there are any. The frame's blocks and the sward's tables must be bound,
  /// and for any variant but the plain one the moving fields.
  bool prepare(StreamBuffer& stream, const FramePlan& plan, std::span<const SpeciesParams> species,
               GrassVariant variant);
  void draw();

  std::uint64_t triangles() const { return triangles_; }

 private:
  /// Tiles whose strips have equally many quads a side.
  struct Run {
    std::uint32_t first_tile = 0;
    std::uint32_t tiles = 0;
    std::uint32_t quads = 1;
    std::uint32_t first_column = 0;
  };
  void lay(const Run& run, GLuint program);

  StripTexture texture_;
  MovingProgram lay_program_;
  GlProgram draw_program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_{"strip vertices"};
  GlBuffer near_indices_{"near strips' indices"};
  GlBuffer far_indices_{"far strips' indices"};
  TexelView tiles_{GL_RGBA32UI, "strip tiles"};
  TexelView species_{GL_RGBA32F, "strip species"};
  TexelView traits_{GL_RGBA32F, "strip traits"};
  Run near_;
  Run far_;
  std::uint64_t triangles_ = 0;
};

}  // namespace prairie
