#include "render/grass/ground_pass.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "lod/sward/flat_map.h"
#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSide = kPatchQuads + 1;  // vertices along a side
constexpr std::uint32_t kPerPatch = kSide * kSide;
constexpr std::uint32_t kSlots = 4096;
constexpr double kAnchorStepM = 1024.0;

struct Vertex {
  float height_m;
  std::int16_t normal[4];
};
static_assert(sizeof(Vertex) == 12);

// As PatchParams in shaders/pass/ground.vert.
struct PatchParams {
  glm::vec2 anchor_from_corner_m;
  float quad_m;
  float unused;  // std430 rounds the struct to its vec2
};

// Corners of triangles; along a side whose neighbour is coarser, odd vertices move to the even one before
// them.
std::vector<std::uint16_t> patch_indices(std::uint8_t coarser_sides) {
  const auto vertex = [&](std::uint32_t x, std::uint32_t y) {
    if ((x == 0 && (coarser_sides & kWest)) || (x == kSide - 1 && (coarser_sides & kEast))) y &= ~1u;
    if ((y == 0 && (coarser_sides & kSouth)) || (y == kSide - 1 && (coarser_sides & kNorth))) x &= ~1u;
    return static_cast<std::uint16_t>(y * kSide + x);
  };
  std::vector<std::uint16_t> indices;
  const auto add = [&](std::uint16_t a, std::uint16_t b, std::uint16_t c) {
    if (a != b && b != c && c != a) indices.insert(indices.end(), {a, b, c});
  };
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint16_t sw = vertex(x, y), se = vertex(x + 1, y), nw = vertex(x, y + 1),
                          ne = vertex(x + 1, y + 1);
      // Diagonals alternate so that each fan around a stitched vertex closes.
      if ((x + y) % 2 == 0) {
        add(sw, se, ne);
        add(sw, ne, nw);
      } else {
        add(sw, se, nw);
        add(se, ne, nw);
      }
    }
  }
  return indices;
}

std::uint64_t key_of(const GroundPatch& patch) {
  return (static_cast<std::uint64_t>(patch.level) << 58) |
         ((static_cast<std::uint64_t>(static_cast<std::uint32_t>(patch.column)) & 0x1fffffffu) << 29) |
         (static_cast<std::uint64_t>(static_cast<std::uint32_t>(patch.row)) & 0x1fffffffu);
}

GlTexture upload_flat_map(const FlatMap& map, bool repeats) {
  GlTexture texture = make_texture(GL_TEXTURE_2D);
  const int levels = 1 + static_cast<int>(std::floor(std::log2(std::max(map.columns, map.rows))));
  glTextureStorage2D(texture.get(), levels, GL_SRGB8_ALPHA8, map.columns, map.rows);
  glTextureSubImage2D(texture.get(), 0, 0, 0, map.columns, map.rows, GL_RGBA, GL_UNSIGNED_BYTE,
                      map.srgb_and_cover.data());
  glGenerateTextureMipmap(texture.get());
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  const GLint wrap = repeats ? GL_REPEAT : GL_CLAMP_TO_EDGE;
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_S, wrap);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, wrap);
  return texture;
}

}  // namespace

GroundPass::GroundPass(const World& world, const std::filesystem::path& shader_folder,
                       std::span<const double> blade_area_from_above_m2)
    : world_(&world),
      program_(shader_folder, {"pass/ground.vert", "pass/ground.frag"}),
      vertex_array_(make_vertex_array()) {
  const FlatMap flat_map = make_flat_map(world.meadow(), blade_area_from_above_m2);
  flat_period_m_ = flat_map.period_m;
  flat_map_ = upload_flat_map(flat_map, world.meadow().repeats);

  tile_morphs_ = make_texture(GL_TEXTURE_2D);
  glTextureStorage2D(tile_morphs_.get(), 1, GL_R8, layouts::kTileMorphSide, layouts::kTileMorphSide);

  std::vector<std::uint16_t> indices;
  for (std::uint8_t sides = 0; sides < index_ranges_.size(); ++sides) {
    const std::vector<std::uint16_t> patch = patch_indices(sides);
    index_ranges_[sides] = {static_cast<std::uint32_t>(indices.size()),
                            static_cast<std::uint32_t>(patch.size())};
    indices.insert(indices.end(), patch.begin(), patch.end());
  }
  indices_.upload(std::span<const std::uint16_t>(indices));
  vertices_.reserve(std::size_t{kSlots} * kPerPatch * sizeof(Vertex));
  for (std::uint32_t slot = kSlots; slot-- > 0;) free_slots_.push_back(slot);

  const GLuint array = vertex_array_.get();
  glVertexArrayVertexBuffer(array, 0, vertices_.get(), 0, sizeof(Vertex));
  glVertexArrayElementBuffer(array, indices_.get());
  glEnableVertexArrayAttrib(array, 0);
  glVertexArrayAttribFormat(array, 0, 1, GL_FLOAT, GL_FALSE, offsetof(Vertex, height_m));
  glVertexArrayAttribBinding(array, 0, 0);
  glEnableVertexArrayAttrib(array, 1);
  glVertexArrayAttribFormat(array, 1, 3, GL_SHORT, GL_TRUE, offsetof(Vertex, normal));
  glVertexArrayAttribBinding(array, 1, 0);
}

glm::dvec3 GroundPass::anchor_m(glm::dvec3 eye_m) const {
  const double base_m = std::round(static_cast<double>(world_->meadow().ground.range().min_m));
  return {kAnchorStepM * std::round(eye_m.x / kAnchorStepM),
          kAnchorStepM * std::round(eye_m.y / kAnchorStepM), base_m};
}

void GroundPass::fill_slot(std::uint32_t slot, const GroundPatch& patch) {
  const HeightField& ground = world_->meadow().ground;
  const double side_m = patch_side_m(patch.level);
  const double quad_m = side_m / kPatchQuads;
  const glm::dvec2 corner_m = side_m * glm::dvec2(patch.column, patch.row);
  const double base_m = anchor_m({}).z;
  float heights_m[kPerPatch];
  ground.sample_lattice(corner_m, quad_m, kSide, kSide, heights_m);
  Vertex vertices[kPerPatch];
  for (std::uint32_t n = 0; n < kPerPatch; ++n) {
    const glm::vec3 normal = ground.normal(corner_m + quad_m * glm::dvec2(n % kSide, n / kSide));
    const auto packed = [](float x) {
      return static_cast<std::int16_t>(std::lround(32767.0f * std::clamp(x, -1.0f, 1.0f)));
    };
    vertices[n] = {static_cast<float>(static_cast<double>(heights_m[n]) - base_m),
                   {packed(normal.x), packed(normal.y), packed(normal.z), 0}};
  }
  glNamedBufferSubData(vertices_.get(), static_cast<GLintptr>(slot * sizeof(vertices)), sizeof(vertices),
                       vertices);
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
  const double tile_m = world_->meadow().tile_m;
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

void GroundPass::draw(const FramePlan& plan, glm::dvec3 anchor_m, GrassVariant variant) {
  ++frame_;
  triangles_drawn_ = 0;
  std::vector<PatchParams> params(kSlots);
  std::vector<GLsizei> counts;
  std::vector<const void*> offsets;
  std::vector<GLint> base_vertices;
  for (const GroundPatch& patch : plan.ground) {
    const std::uint32_t slot = slot_of(patch);
    const double side_m = patch_side_m(patch.level);
    params[slot] = {glm::vec2(side_m * glm::dvec2(patch.column, patch.row) - glm::dvec2(anchor_m)),
                    static_cast<float>(side_m / kPatchQuads), 0.0f};
    const IndexRange range = index_ranges_[patch.coarser_sides];
    counts.push_back(static_cast<GLsizei>(range.count));
    offsets.push_back(reinterpret_cast<const void*>(std::uintptr_t{range.first} * sizeof(std::uint16_t)));
    base_vertices.push_back(static_cast<GLint>(slot * kPerPatch));
    triangles_drawn_ += range.count / 3;
  }
  patch_params_.upload(std::span<const PatchParams>(params));
  upload_morphs(plan);

  const GLuint program = program_.get(variant);
  glUseProgram(program);
  glProgramUniform1ui(program, 0, kSide);
  glBindVertexArray(vertex_array_.get());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 5, patch_params_.get());
  glBindTextureUnit(0, flat_map_.get());
  glBindTextureUnit(1, tile_morphs_.get());
  glMultiDrawElementsBaseVertex(GL_TRIANGLES, counts.data(), GL_UNSIGNED_SHORT, offsets.data(),
                                static_cast<GLsizei>(counts.size()), base_vertices.data());
}

}  // namespace prairie
