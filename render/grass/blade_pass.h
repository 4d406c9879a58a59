// Draws the plan's 3D blades. Compute shaders plant and pose them and leave lit vertices, as many blades at a
// time as a storage buffer holds; each group of equal meshes is then drawn with indices that all groups of
// its kind share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include "animation/touched_blades.h"
#include "generator/meadow.h"
#include "lod/frame_plan.h"
#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/compute_batch.h"
#include "render/grass/moving_program.h"
#include "render/grass/touched_chains.h"

namespace prairie {

/// Cells with blades to be drawn, grouped by mesh, and what their table words index (lod/frame_plan.h).
struct PlannedBlades {
  std::span<const DrawnCell> cells;
  std::span<const CellGroup> groups;
  std::span<const float> tables;
};

class BladePass {
 public:
  static constexpr DrawState kState{};

  BladePass(const Meadow& meadow, const std::filesystem::path& shader_folder);

  /// Takes a frame's cells; whether there are any. `species`: as the field has them, found by the renderer
  /// where they say so. For any variant but the plain one the moving fields must be bound
  /// (render/grass/moving_fields.h).
  bool prepare(StreamBuffer& stream, const PlannedBlades& blades, std::span<const SpeciesParams> species,
               GrassVariant variant = {}, const TouchedBlades* touched = nullptr);
  /// Draws them; the same cells may be drawn several times. The frame's blocks and the sward's tables must be
  /// bound.
  void draw(StreamBuffer& stream) { draw(stream, draw_program_.get()); }
  /// The same by another program, which takes GrownVertex as vertex attributes 0 and 1.
  void draw(StreamBuffer& stream, GLuint program);

  /// Of a mesh that ends in a point.
  static std::uint32_t vertices_per_blade(std::uint32_t segments);

  std::uint64_t spline_triangles() const { return spline_triangles_; }
  std::uint64_t hermite_triangles() const { return hermite_triangles_; }

 private:
  /// Cells of one mesh that are grown by one dispatch.
  struct Run {
    bool is_spline = false;
    bool is_touched = false;  // has cells with blades that move by themselves
    std::uint32_t segments = 1;
    std::size_t first_cell = 0;
    std::size_t cell_count = 0;
    std::uint32_t blades = 0;
    std::uint32_t first_vertex = 0;
  };
  /// Runs whose vertices fit into one buffer.
  struct Batch {
    std::size_t first_run = 0;
    std::size_t run_count = 0;
  };

  void add_runs(const CellGroup& group, std::span<const DrawnCell> cells, bool is_touched);
  void reserve_vertices();
  GLuint grow_program(const Run& run);
  GLuint indices_for(std::uint32_t segments);
  void grow(StreamBuffer& stream, const Batch& batch);
  void draw_run(const Run& run);

  MovingProgram spline_program_;
  MovingProgram hermite_program_;
  MovingProgram touched_spline_program_;
  MovingProgram touched_hermite_program_;
  TouchedChains touched_;
  GlProgram draw_program_;
  GlVertexArray vertex_array_;
  ComputeBatch compute_;
  GlBuffer vertices_{"grown vertices"};
  std::map<std::uint32_t, GlBuffer> indices_;  // by segments
  std::vector<DrawnCell> cells_;
  std::vector<Run> runs_;
  std::vector<Batch> batches_;
  std::size_t batch_bytes_ = 0;  // that the last batch holds so far
  GrassVariant variant_;
  const Batch* grown_ = nullptr;  // the batch whose vertices the buffer holds
  std::uint64_t spline_triangles_ = 0;
  std::uint64_t hermite_triangles_ = 0;
};

}  // namespace prairie
