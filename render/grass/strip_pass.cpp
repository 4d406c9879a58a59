#include "render/grass/strip_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "render/gl/shader_program.h"
#include "render/gl/vertex_layout.h"
#include "render/grass/compute_batch.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSides = 4;
constexpr std::uint32_t kNearQuads = layouts::kStripQuads;
// Sides whose indices lie ready; more are drawn by shifting the base vertex.
constexpr std::uint32_t kIndexedSides = 4096;

constexpr std::array<VertexAttribute, 4> kVertexAttributes{{
    {3, GL_FLOAT, offsetof(StripVertex, position_m)},
    {3, GL_UNSIGNED_INT_10F_11F_11F_REV, offsetof(StripVertex, radiance)},
    {3, GL_FLOAT, offsetof(StripVertex, place)},
    {1, GL_FLOAT, offsetof(StripVertex, shown)},
}};

std::uint32_t columns_of(std::uint32_t quads) {
  return quads + 1;
}

std::vector<std::uint16_t> indices_of(std::uint32_t quads) {
  std::vector<std::uint16_t> indices;
  for (std::uint32_t side = 0; side < kIndexedSides; ++side) {
    for (std::uint32_t quad = 0; quad < quads; ++quad) {
      const std::uint32_t foot = 2 * (side * columns_of(quads) + quad);
      for (const std::uint32_t corner : {foot, foot + 2, foot + 1, foot + 1, foot + 2, foot + 3})
        indices.push_back(static_cast<std::uint16_t>(corner));
    }
  }
  return indices;
}

}  // namespace

StripPass::StripPass(const std::filesystem::path& shader_folder, StripTexture texture)
    : texture_(std::move(texture)),
      lay_program_(shader_folder, {"pass/strips.comp"}),
      draw_program_(make_program(shader_folder, {"pass/strip.vert", "pass/strip.frag"})),
      vertex_array_(make_vertex_array(kVertexAttributes, "strips")) {
  near_indices_.upload(std::span<const std::uint16_t>(indices_of(kNearQuads)));
  far_indices_.upload(std::span<const std::uint16_t>(indices_of(1)));
}

void StripPass::lay(const Run& run, GLuint program) {
  if (run.tiles == 0) return;
  const std::uint32_t columns = run.tiles * kSides * columns_of(run.quads);
  glProgramUniform1ui(program, layouts::kLayColumnCount, columns);
  glProgramUniform1ui(program, layouts::kLayFirstTile, run.first_tile);
  glProgramUniform1ui(program, layouts::kLayFirstColumn, run.first_column);
  glProgramUniform1ui(program, layouts::kLayQuads, run.quads);
  glDispatchCompute((columns + layouts::kPlantingGroup - 1) / layouts::kPlantingGroup, 1, 1);
}

bool StripPass::prepare(StreamBuffer& stream, const FramePlan& plan, std::span<const SpeciesParams> species,
                        GrassVariant variant) {
  const auto tiles = static_cast<std::uint32_t>(plan.strips.size());
  near_ = {0, plan.near_strips, kNearQuads, 0};
  far_ = {plan.near_strips, tiles - plan.near_strips, 1, plan.near_strips * kSides * columns_of(kNearQuads)};
  triangles_ = std::uint64_t{2} * kSides * (near_.tiles * near_.quads + far_.tiles * far_.quads);
  if (tiles == 0) return false;
  tiles_.show(stream, std::span<const StripTile>(plan.strips));
  species_.show(stream, species);
  traits_.show(stream, std::span<const StripTraits>(texture_.traits));
  vertices_.reserve((far_.first_column + std::size_t{far_.tiles} * kSides * columns_of(1)) * 2 *
                    sizeof(StripVertex));
  set_vertices(vertex_array_, vertices_, sizeof(StripVertex));
  glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layouts::kResultBuffer, vertices_.get());
  const GLuint lay_program = lay_program_.get(variant);
  glUseProgram(lay_program);
  tiles_.bind(layouts::kStripTileUnit);
  traits_.bind(layouts::kStripTraitsUnit);
  species_.bind(layouts::kSpeciesUnit);
  lay(near_, lay_program);
  lay(far_, lay_program);
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  return true;
}

void StripPass::draw() {
  glUseProgram(draw_program_.get());
  glBindVertexArray(vertex_array_.get());
  glBindTextureUnit(layouts::kStripUnit, texture_.texture.get());
  for (const Run& run : {near_, far_}) {
    glVertexArrayElementBuffer(vertex_array_.get(),
                               run.quads == 1 ? far_indices_.get() : near_indices_.get());
    for (std::uint32_t first = 0; first < run.tiles * kSides; first += kIndexedSides) {
      const std::uint32_t sides = std::min(kIndexedSides, run.tiles * kSides - first);
      glDrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(sides * run.quads * 6), GL_UNSIGNED_SHORT,
                               nullptr,
                               static_cast<GLint>(2 * (run.first_column + first * columns_of(run.quads))));
    }
  }
}

}  // namespace prairie
