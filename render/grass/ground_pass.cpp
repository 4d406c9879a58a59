#include "render/grass/ground_pass.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "lod/sward/flat_map.h"
#include "render/gl/vertex_layout.h"
#include "render/grass/ground_mesh.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSlots = 4096;

constexpr std::array<VertexAttribute, 2> kVertexAttributes{{
    {1, GL_FLOAT, offsetof(GroundVertex, height_m)},
    {3, GL_SHORT, offsetof(GroundVertex, normal), Numbers::kNormalized},
}};

std::uint64_t key_of(const GroundPatch& patch) {
  return (static_cast<std::uint64_t>(patch.level) << 58) |
         ((static_cast<std::uint64_t>(static_cast<std::uint32_t>(patch.column)) & 0x1fffffffu) << 29) |
         (static_cast<std::uint64_t>(static_cast<std::uint32_t>(patch.row)) & 0x1fffffffu);
}

GlTexture upload_flat_map(const FlatMap& map, bool repeats) {
  GlTexture texture = make_texture(GL_TEXTURE_2D, "flat map");
  const int levels = 1 + static_cast<int>(std::floor(std::log2(std::max(map.columns, map.rows))));
  glTextureStorage2D(texture.get(), levels, GL_SRGB8_ALPHA8, map.columns, map.rows);
  glTextureSubImage2D(texture.get(), 0, 0, 0, map.columns, map.rows, GL_RGBA, GL_UNSIGNED_BYTE,
                      map.srgb_and_cover.data());
  glGenerateTextureMipmap(texture.get());
  set_sampling(texture, {.minified = GL_LINEAR_MIPMAP_LINEAR,
                         .magnified = GL_LINEAR,
                         .wrap = static_cast<GLenum>(repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE)});
  return texture;
}

}  // namespace

GroundPass::GroundPass(const Meadow& meadow, const std::filesystem::path& shader_folder,
                       std::span<const double> blade_area_from_above_m2)
    : meadow_(&meadow),
      program_(shader_folder, {"pass/ground.vert", "pass/ground.frag"}),
      vertex_array_(make_vertex_array(kVertexAttributes, "ground")),
      tile_morphs_(make_texture(GL_TEXTURE_2D, "tile morphs")) {
  const FlatMap flat_map = make_flat_map(meadow, blade_area_from_above_m2);
  flat_period_m_ = flat_map.period_m;
  flat_map_ = upload_flat_map(flat_map, meadow.repeats);
  glTextureStorage2D(tile_morphs_.get(), 1, GL_R8, layouts::kTileMorphSide, layouts::kTileMorphSide);

  std::vector<std::uint16_t> indices;
  for (std::uint8_t sides = 0; sides < index_ranges_.size(); ++sides) {
    const std::vector<std::uint16_t> patch = patch_indices(sides);
    index_ranges_[sides] = {static_cast<std::uint32_t>(indices.size()),
                            static_cast<std::uint32_t>(patch.size())};
    indices.insert(indices.end(), patch.begin(), patch.end());
  }
  indices_.upload(std::span<const std::uint16_t>(indices));
  vertices_.reserve(std::size_t{kSlots} * kGroundVertices * sizeof(GroundVertex));
  for (std::uint32_t slot = kSlots; slot-- > 0;) free_slots_.push_back(slot);
  set_vertices(vertex_array_, vertices_, sizeof(GroundVertex));
  glVertexArrayElementBuffer(vertex_array_.get(), indices_.get());
}

void GroundPass::fill_slot(std::uint32_t slot, const GroundPatch& patch) {
  const auto vertices = patch_vertices(*meadow_, patch);
  glNamedBufferSubData(vertices_.get(), static_cast<GLintptr>(slot * sizeof(vertices)), sizeof(vertices),
                       vertices.data());
}

std::uint32_t GroundPass::slot_of(const GroundPatch& patch) {
  const auto [entry, is_new] = slots_.try_emplace(key_of(patch));
  if (is_new) {
    if (free_slots_.empty()) {
      std::erase_if(slots_, [&](const auto& used) {
        const bool is_old = used.second.last_frame + 1 < frame_ && used.first != entry->first;
        if (is_old) free_slots_.push_back(used.second.index);
        return is_old;
      });
    }
    assert(!free_slots_.empty());  // no view holds as many patches as there are slots
    entry->second.index = free_slots_.back();
    free_slots_.pop_back();
    fill_slot(entry->second.index, patch);
  }
  entry->second.last_frame = frame_;
  return entry->second.index;
}

void GroundPass::upload_morphs(const FramePlan& plan) {
  constexpr int kSideTiles = layouts::kTileMorphSide;
  constexpr std::uint8_t kUnknown = 255;
  morph_steps_.assign(std::size_t{kSideTiles} * kSideTiles, kUnknown);
  const double tile_m = meadow_->tile_m;
  const int west = static_cast<int>(std::floor(plan.camera.eye_m.x / tile_m)) - kSideTiles / 2;
  const int south = static_cast<int>(std::floor(plan.camera.eye_m.y / tile_m)) - kSideTiles / 2;
  for (const TileMorph& tile : plan.morphs) {
    const int column = tile.i - west, row = tile.j - south;
    if (column < 0 || column >= kSideTiles || row < 0 || row >= kSideTiles) continue;
    morph_steps_[static_cast<std::size_t>(row) * kSideTiles + static_cast<std::size_t>(column)] =
        static_cast<std::uint8_t>(std::lround(layouts::kTileMorphSteps * tile.morph));
  }
  glTextureSubImage2D(tile_morphs_.get(), 0, 0, 0, kSideTiles, kSideTiles, GL_RED, GL_UNSIGNED_BYTE,
                      morph_steps_.data());
}

void GroundPass::draw(const FramePlan& plan, GrassVariant variant) {
  ++frame_;
  triangles_drawn_ = 0;
  const glm::dvec2 anchor_m(ground_anchor_m(*meadow_, plan.camera.eye_m));
  std::vector<GroundPatchParams> params(kSlots);
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  std::vector<GLint> base_vertices;
  for (const GroundPatch& patch : plan.ground) {
    const std::uint32_t slot = slot_of(patch);
    const double side_m = patch_side_m(patch.level);
    params[slot] = {glm::vec2(side_m * glm::dvec2(patch.column, patch.row) - anchor_m),
                    static_cast<float>(side_m / kPatchQuads), 0.0f};
    const IndexRange range = index_ranges_[patch.coarser_sides];
    counts.push_back(static_cast<GLsizei>(range.count));
    offsets.push_back(reinterpret_cast<const void*>(std::uintptr_t{range.first} * sizeof(std::uint16_t)));
    base_vertices.push_back(static_cast<GLint>(slot * kGroundVertices));
    triangles_drawn_ += range.count / 3;
  }
  patch_params_.upload(std::span<const GroundPatchParams>(params));
  upload_morphs(plan);

  const GLuint program = program_.get(variant);
  glUseProgram(program);
  glProgramUniform1ui(program, layouts::kGroundVerticesPerSide, kGroundSide);
  glBindVertexArray(vertex_array_.get());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layouts::kThingBuffer, patch_params_.get());
  glBindTextureUnit(layouts::kFlatMapUnit, flat_map_.get());
  glBindTextureUnit(layouts::kTileMorphUnit, tile_morphs_.get());
  glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, offsets.data(),
                                static_cast<GLsizei>(counts.size()), base_vertices.data());
}

}  // namespace prairie
