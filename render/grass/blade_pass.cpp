#include "render/grass/blade_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "generator/cell_table.h"
#include "render/gl/shader_program.h"
#include "render/gl/vertex_layout.h"

namespace prairie {
namespace {

// Blades whose indices lie ready, of 16 bits; more are drawn by shifting the base vertex.
constexpr std::uint32_t kIndexedBlades = 3600;
constexpr std::uint32_t kMostSegments = 8;
static_assert(kIndexedBlades * (2 * kMostSegments + 1) <= 65536);

constexpr std::array<VertexAttribute, 2> kVertexAttributes{{
    {3, GL_FLOAT, offsetof(GrownVertex, position_m)},
    {3, GL_UNSIGNED_INT_10F_11F_11F_REV, offsetof(GrownVertex, radiance)},
}};

std::uint32_t triangles_of(std::uint32_t segments) {
  return 2 * segments - 1;
}
std::size_t bytes_of(std::uint32_t segments) {
  return BladePass::vertices_per_blade(segments) * sizeof(GrownVertex);
}

}  // namespace

std::uint32_t BladePass::vertices_per_blade(std::uint32_t segments) {
  return 2 * segments + 1;
}

namespace {

MovingProgram make_grow_program(const Meadow& meadow, const std::filesystem::path& shader_folder,
                                const char* shape, const char* origin) {
  return {shader_folder,
          {"pass/grow.comp"},
          {shape, origin, planting_variant(PlantingLattice(meadow).feature_patches > 0)}};
}

}  // namespace

BladePass::BladePass(const Meadow& meadow, const std::filesystem::path& shader_folder)
    : spline_program_(make_grow_program(meadow, shader_folder, "SPLINE_BLADES", "")),
      hermite_program_(make_grow_program(meadow, shader_folder, "", "")),
      touched_spline_program_(make_grow_program(meadow, shader_folder, "SPLINE_BLADES", "TOUCHED")),
      touched_hermite_program_(make_grow_program(meadow, shader_folder, "", "TOUCHED")),
      draw_program_(make_program(shader_folder, {"pass/blade.vert", "pass/blade.frag"})),
      vertex_array_(make_vertex_array(kVertexAttributes, "blades")) {}

GLuint BladePass::indices_for(std::uint32_t segments) {
  const auto [entry, is_new] = indices_.try_emplace(segments, "blade indices");
  if (is_new) {
    std::vector<std::uint16_t> indices;
    indices.reserve(std::size_t{kIndexedBlades} * triangles_of(segments) * 3);
    for (std::uint32_t blade = 0; blade < kIndexedBlades; ++blade) {
      const std::uint32_t first = blade * BladePass::vertices_per_blade(segments);
      for (std::uint32_t n = first; n < first + triangles_of(segments); ++n) {
        for (const std::uint32_t corner : {n, n + 1, n + 2})
          indices.push_back(static_cast<std::uint16_t>(corner));
      }
    }
    entry->second.upload(std::span<const std::uint16_t>(indices));
  }
  return entry->second.get();
}

bool BladePass::prepare(StreamBuffer& stream, const PlannedBlades& blades,
                        std::span<const SpeciesParams> species, GrassVariant variant,
                        const TouchedBlades* touched) {
  variant_ = variant;
  cells_.clear();
  runs_.clear();
  batches_.clear();
  grown_ = nullptr;
  spline_triangles_ = hermite_triangles_ = 0;
  if (blades.cells.empty()) return false;
  compute_.set_tables(stream, blades.tables, species);
  const bool has_touched = touched != nullptr && touched->size() > 0;
  if (has_touched) touched_.set(stream, *touched);
  batch_bytes_ = kStorageLimitBytes;
  for (const CellGroup& group : blades.groups) {
    std::vector<DrawnCell> plain, moved;
    // Feet of blades that have begun to slide towards strips are no longer where they were touched.
    for (const DrawnCell& cell : blades.cells.subspan(group.first_cell, group.cell_count))
      (has_touched && cell.morph <= 0.0f && touched_.holds(cell.planted.key) ? moved : plain).push_back(cell);
    add_runs(group, plain, false);
    add_runs(group, moved, true);
  }
  reserve_vertices();
  return true;
}

void BladePass::add_runs(const CellGroup& group, std::span<const DrawnCell> cells, bool is_touched) {
  const std::size_t most = most_blades(bytes_of(group.segments));
  const std::vector<DrawnCell> pieces = pieces_of(cells, most);
  for (const CellRun& run : runs_of(pieces, most)) {
    const std::size_t run_bytes = run.blades * bytes_of(group.segments);
    if (batch_bytes_ + run_bytes > kStorageLimitBytes) {
      batches_.push_back({runs_.size(), 0});
      batch_bytes_ = 0;
    }
    ++batches_.back().run_count;
    runs_.push_back({group.is_spline, is_touched, group.segments, cells_.size() + run.first, run.count,
                     run.blades, static_cast<std::uint32_t>(batch_bytes_ / sizeof(GrownVertex))});
    batch_bytes_ += run_bytes;
    (group.is_spline ? spline_triangles_ : hermite_triangles_) +=
        std::uint64_t{run.blades} * triangles_of(group.segments);
  }
  cells_.insert(cells_.end(), pieces.begin(), pieces.end());
}

void BladePass::reserve_vertices() {
  const Run& last = runs_.back();
  const std::size_t last_bytes =
      (last.first_vertex + std::size_t{last.blades} * BladePass::vertices_per_blade(last.segments)) *
      sizeof(GrownVertex);
  vertices_.reserve(batches_.size() > 1 ? kStorageLimitBytes : last_bytes);
  set_vertices(vertex_array_, vertices_, sizeof(GrownVertex));
}

GLuint BladePass::grow_program(const Run& run) {
  if (run.is_touched)
    return (run.is_spline ? touched_spline_program_ : touched_hermite_program_).get(variant_);
  return (run.is_spline ? spline_program_ : hermite_program_).get(variant_);
}

void BladePass::grow(StreamBuffer& stream, const Batch& batch) {
  // What is drawn from the buffer's former contents must be done before they are overwritten.
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layouts::kResultBuffer, vertices_.get());
  for (std::size_t n = batch.first_run; n < batch.first_run + batch.run_count; ++n) {
    const Run& run = runs_[n];
    const GLuint program = grow_program(run);
    if (run.is_touched) touched_.show(stream, std::span(cells_).subspan(run.first_cell, run.cell_count));
    glProgramUniform1ui(program, layouts::kGrowSegments, run.segments);
    glProgramUniform1ui(program, layouts::kGrowFirstVertex, run.first_vertex);
    compute_.dispatch(stream, program, std::span(cells_).subspan(run.first_cell, run.cell_count));
  }
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  grown_ = &batch;
}

void BladePass::draw_run(const Run& run) {
  glVertexArrayElementBuffer(vertex_array_.get(), indices_for(run.segments));
  for (std::uint32_t first = 0; first < run.blades; first += kIndexedBlades) {
    const std::uint32_t blades = std::min(kIndexedBlades, run.blades - first);
    glDrawElementsBaseVertex(
        GL_TRIANGLES, static_cast<GLsizei>(blades * triangles_of(run.segments) * 3), GL_UNSIGNED_SHORT,
        nullptr, static_cast<GLint>(run.first_vertex + first * BladePass::vertices_per_blade(run.segments)));
  }
}

void BladePass::draw(StreamBuffer& stream, GLuint program) {
  for (const Batch& batch : batches_) {
    if (grown_ != &batch) grow(stream, batch);
    glUseProgram(program);
    glBindVertexArray(vertex_array_.get());
    for (std::size_t n = batch.first_run; n < batch.first_run + batch.run_count; ++n) draw_run(runs_[n]);
  }
}

}  // namespace prairie
