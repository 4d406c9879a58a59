#include "render/grass/strip_painter.h"

#include <algorithm>
#include <bit>

#include "generator/cell_table.h"
#include "lod/sward/strip_texture.h"
#include "lod/thinning.h"
#include "render/gl/draw_state.h"
#include "render/gl/shader_program.h"
#include "render/gl/uniform_block.h"
#include "shaders/shared/layouts.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSegments = 4;
constexpr int kLevels = std::bit_width(static_cast<unsigned>(kStripColumns));
// Narrower blades would be broken into dots by the texture.
constexpr float kLeastTexels = 1.2f;

// The viewer's side of each facing (towards the eye), and what lies to the right there.
struct Facing {
  glm::vec3 towards_eye;
  glm::vec3 along;
};
constexpr Facing kFacing[kStripFacings] = {{{0.0f, -1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
                                           {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}},
                                           {{0.0f, 1.0f, 0.0f}, {1.0f, 0.0f, 0.0f}},
                                           {{-1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}}};

// What one strip stands for: a quarter of a tile's blades, on a square as large as a tile.
struct StripSward {
  SpeciesParams species;
  float density_per_m2;
  float longest_m;
};

StripSward strip_sward(const SpeciesParams& species, float texel_m) {
  StripSward sward{species, 0.0f, 0.0f};
  sward.species.width_m = std::max(species.width_m, kLeastTexels * texel_m);
  sward.density_per_m2 = 0.25f * species.densest_per_m2 * species.width_m / sward.species.width_m;
  sward.longest_m = species.height_m * (1.0f + layouts::kTallestSpread * species.height_spread);
  return sward;
}

// The cell of a species, number `index` of the field, among blades of all.
struct StripCell {
  std::vector<DrawnCell> cells;
  std::vector<CellGroup> groups;
  std::vector<float> tables;

  std::uint32_t blades() const { return cells.empty() ? 0 : cells.front().drawn; }
  PlannedBlades planned() const { return {cells, groups, tables}; }
};

StripCell strip_cell(const StripSward& sward, std::uint32_t index, float all_per_m2, double tile_m,
                     std::uint64_t seed) {
  StripCell strip;
  const CellTables tables = uniform_cell(sward.species, sward.density_per_m2, tile_m, seed);
  if (tables.cells.empty()) return strip;
  DrawnCell cell{};
  cell.planted = tables.cells.front();
  // The light in it is that of the whole sward.
  cell.planted.other_density_per_m2 = std::max(all_per_m2 - sward.density_per_m2, 0.0f);
  cell.planted.species = index;
  cell.drawn = cell.planted.planted;
  strip.cells.push_back(cell);
  strip.groups.push_back({false, kSegments, 0, 1});
  strip.tables = tables.tables;
  return strip;
}

// A strip as it is seen from a side, in parallel projection (strip_blade.vert has one of its own), as finely
// as a picture shows what is 1 m away.
ViewParams strip_view(const Facing& facing) {
  Camera from_aside;
  from_aside.orthographic_height_m = 1.0;
  ViewParams view{};
  view.parallel = 1.0f;
  view.towards_eye = facing.towards_eye;
  view.pixel_m = static_cast<float>(Camera{}.pixel_m());
  view.lod = tier_coefficients(Tier::kHermite, Quality::kHigh, 1.0, from_aside);
  return view;
}

GlTexture make_strip_texture(int layers) {
  GlTexture texture = make_texture(GL_TEXTURE_2D_ARRAY, "strips");
  glTextureStorage3D(texture.get(), kLevels, GL_RGBA8, kStripColumns, kStripRows, layers);
  set_sampling(texture, {.minified = GL_NEAREST_MIPMAP_NEAREST, .magnified = GL_NEAREST, .wrap = GL_REPEAT});
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

// Draws blades into radiance and rank, and reads them back.
class StripCanvas {
 public:
  StripCanvas() {
    glTextureStorage2D(color_.get(), 1, GL_RGBA32F, kStripColumns, kStripRows);
    glTextureStorage2D(depth_.get(), 1, GL_DEPTH_COMPONENT32F, kStripColumns, kStripRows);
    glNamedFramebufferTexture(framebuffer_.get(), GL_COLOR_ATTACHMENT0, color_.get(), 0);
    glNamedFramebufferTexture(framebuffer_.get(), GL_DEPTH_ATTACHMENT, depth_.get(), 0);
  }

  void begin() const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get());
    glViewport(0, 0, kStripColumns, kStripRows);
    set_draw_state(BladePass::kState);
    const float nothing[4] = {0.0f, 0.0f, 0.0f, 1.0f};
    const float far = 0.0f;
    glClearNamedFramebufferfv(framebuffer_.get(), GL_COLOR, 0, nothing);
    glClearNamedFramebufferfv(framebuffer_.get(), GL_DEPTH, 0, &far);
  }

  StripDrawing drawing() const {
    StripDrawing drawing{kStripColumns, kStripRows, {}};
    drawing.rgba.resize(std::size_t{4} * kStripColumns * kStripRows);
    glGetTextureImage(color_.get(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(drawing.rgba.size() * sizeof(float)), drawing.rgba.data());
    return drawing;
  }

 private:
  GlTexture color_ = make_texture(GL_TEXTURE_2D, "strip color");
  GlTexture depth_ = make_texture(GL_TEXTURE_2D, "strip depth");
  GlFramebuffer framebuffer_ = make_framebuffer("strip");
};

void draw_strip(StreamBuffer& stream, BladePass& blades, const StripCell& strip, const StripSward& sward,
                std::span<const SpeciesParams> species, double tile_m, const Facing& facing, GLuint program) {
  bind_uniform_block(stream, layouts::kViewBlock, strip_view(facing));
  blades.prepare(stream, strip.planned(), species);
  glProgramUniform1ui(program, layouts::kStripBladeVertices, BladePass::vertices_per_blade(kSegments));
  glProgramUniform1f(program, layouts::kStripBladeCount, static_cast<float>(strip.blades()));
  glProgramUniform3fv(program, layouts::kStripBladeAlong, 1, &facing.along[0]);
  glProgramUniform1f(program, layouts::kStripBladeHeight, sward.longest_m);
  const auto side_m = static_cast<float>(tile_m);
  for (const float shift_m : {-side_m, 0.0f, side_m}) {
    glProgramUniform1f(program, layouts::kStripBladeShift, shift_m);
    blades.draw(stream, program);
  }
}

void upload_levels(const GlTexture& texture, int layer, const StripDrawing& drawing) {
  const std::vector<StripLevel> levels = strip_levels(drawing);
  for (int n = 0; n < kLevels; ++n) {
    const StripLevel& level = levels[static_cast<std::size_t>(n)];
    glTextureSubImage3D(texture.get(), n, 0, 0, layer, level.columns, level.rows, 1, GL_RGBA,
                        GL_UNSIGNED_BYTE, level.rgba.data());
  }
}

}  // namespace

StripTexture paint_strips(StreamBuffer& stream, BladePass& blades, std::span<const SpeciesParams> species,
                          double tile_m, std::uint64_t seed, const std::filesystem::path& shader_folder) {
  const GlProgram program = make_program(shader_folder, {"pass/strip_blade.vert", "pass/strip_blade.frag"});
  StripTexture strips{make_strip_texture(kStripFacings * static_cast<int>(species.size())),
                      std::vector<StripTraits>(species.size())};
  const StripCanvas canvas;
  float all_per_m2 = 0.0f;
  for (const SpeciesParams& params : species) all_per_m2 += params.densest_per_m2;
  for (std::uint32_t s = 0; s < species.size(); ++s) {
    const StripSward sward = strip_sward(species[s], static_cast<float>(tile_m) / kStripColumns);
    const StripCell strip = strip_cell(sward, s, all_per_m2, tile_m, seed);
    std::vector<SpeciesParams> widened(species.begin(), species.end());
    widened[s] = sward.species;
    StripTraits& traits = strips.traits[s];
    for (int facing = 0; facing < kStripFacings; ++facing) {
      canvas.begin();
      draw_strip(stream, blades, strip, sward, widened, tile_m, kFacing[facing], program.get());
      const StripDrawing drawing = canvas.drawing();
      traits.standing_share = std::max(traits.standing_share, standing_share(drawing));
      upload_levels(strips.texture, static_cast<int>(s) * kStripFacings + facing, drawing);
    }
    traits.tip_share = tip_share(species[s]);
  }
  return strips;
}

}  // namespace prairie
