#include "render/blade_pass.h"

#include <algorithm>

#include "generator/cell_table.h"
#include "render/shader_program.h"

namespace prairie {
namespace {

// Blades whose indices lie ready; more are drawn by shifting the base vertex.
constexpr std::uint32_t kIndexedBlades = 16384;

std::uint32_t vertices_of(std::uint32_t segments) {
  return 2 * segments + 1;
}
std::uint32_t triangles_of(std::uint32_t segments) {
  return 2 * segments - 1;
}

}  // namespace

BladePass::BladePass(const World& world, const std::filesystem::path& shader_folder)
    : world_(&world),
      pose_program_(make_program(shader_folder, {"pass/pose.comp"},
                                 planting_variant(PlantingLattice(world.meadow()).feature_patches > 0))),
      draw_program_(make_program(shader_folder, {"pass/blade.vert", "pass/blade.frag"})),
      vertex_array_(make_vertex_array()),
      posed_texels_(make_texture(GL_TEXTURE_BUFFER)) {
  for (const PlantedSpecies& species : world_->meadow().species) species_.push_back(species.species.params);
}

GLuint BladePass::indices_for(std::uint32_t segments) {
  const auto [entry, is_new] = indices_.try_emplace(segments);
  if (is_new) {
    std::vector<std::uint32_t> indices;
    indices.reserve(std::size_t{kIndexedBlades} * triangles_of(segments) * 3);
    for (std::uint32_t blade = 0; blade < kIndexedBlades; ++blade) {
      const std::uint32_t first = blade * vertices_of(segments);
      for (std::uint32_t n = 0; n < triangles_of(segments); ++n) {
        indices.insert(indices.end(), {first + n, first + n + 1, first + n + 2});
      }
    }
    entry->second.upload(std::span<const std::uint32_t>(indices));
  }
  return entry->second.get();
}

void BladePass::draw(const FramePlan& plan) {
  triangles_drawn_ = 0;
  if (plan.cells.empty()) return;
  batch_.set_tables(plan.tables, species_);
  for (const CellGroup& group : plan.groups) {
    std::vector<DrawnCell> cells = pieces_of(
        std::span(plan.cells).subspan(group.first_cell, group.cell_count), most_blades(sizeof(PosedBlade)));
    const GLuint indices = indices_for(group.segments);
    for (const CellRun& run : runs_of(cells, most_blades(sizeof(PosedBlade)))) {
      batch_.dispatch(pose_program_.get(), std::span(cells).subspan(run.first, run.count), sizeof(PosedBlade),
                      posed_);
      glTextureBuffer(posed_texels_.get(), GL_RGBA32UI, posed_.get());
      glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
      glBindTextureUnit(2, batch_.species_texture());
      glBindTextureUnit(4, posed_texels_.get());
      glUseProgram(draw_program_.get());
      glProgramUniform1ui(draw_program_.get(), 0, group.segments);
      glBindVertexArray(vertex_array_.get());
      glVertexArrayElementBuffer(vertex_array_.get(), indices);
      for (std::uint32_t first = 0; first < run.blades; first += kIndexedBlades) {
        const std::uint32_t blades = std::min(kIndexedBlades, run.blades - first);
        glDrawElementsBaseVertex(
            GL_TRIANGLES, static_cast<GLsizei>(blades * triangles_of(group.segments) * 3), GL_UNSIGNED_INT,
            nullptr, static_cast<GLint>(first * vertices_of(group.segments)));
      }
      triangles_drawn_ += std::uint64_t{run.blades} * triangles_of(group.segments);
    }
  }
}

}  // namespace prairie
