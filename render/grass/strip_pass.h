// Draws the plan's strips (G03 §3.4): a compute shader lays them along the tiles' sides and paints them, an
// alpha test shows as many blades of the texture as the density asks for.
#pragma once

#include <cstdint>
#include <filesystem>

#include "lod/frame_plan.h"
#include "lod/sward/tip_share.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/gl/texel_view.h"
#include "render/grass/moving_program.h"

namespace prairie {

/// What the strips of a species are like.
struct StripTraits {
  float standing_share = 0.0f;  // of the texture's height: up to where blades stand
  float reserved = 0.0f;        // fills the texel
  TipShare tip_share;           // how far wind moves its tips
};

class StripPass {
 public:
  explicit StripPass(const std::filesystem::path& shader_folder);

  /// Lays the plan's strips. The frame block and the sward's tables must be bound.
  /// For any variant but the plain one the moving fields must be too.
  void prepare(StreamBuffer& stream, const FramePlan& plan, std::span<const SpeciesParams> species,
               std::span<const StripTraits> traits, GrassVariant variant);
  /// Draws them with a texture of lod/sward/strip_texture.h.
  void draw(GLuint strip_texture);

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

  MovingProgram lay_program_;
  GlProgram draw_program_;
  GlVertexArray vertex_array_;
  GlBuffer vertices_;
  GlBuffer near_indices_;
  GlBuffer far_indices_;
  TexelView tiles_{GL_RGBA32UI};
  TexelView species_{GL_RGBA32F};
  TexelView traits_{GL_RGBA32F};
  Run near_;
  Run far_;
  std::uint64_t triangles_ = 0;
};

}  // namespace prairie
