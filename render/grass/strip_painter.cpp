#include "render/grass/strip_painter.h"

#include <algorithm>
#include <bit>

#include "generator/cell_table.h"
#include "lod/sward/strip_texture.h"
#include "lod/thinning.h"
#include "render/gl/shader_program.h"

namespace prairie {
namespace {

constexpr std::uint32_t kSegments = 4;
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

// One cell as large as a tile that holds what one strip stands for: a quarter of a tile's blades.
Meadow strip_meadow(const Meadow& meadow, const SpeciesParams& species, float texel_m) {
  Meadow strip;
  strip.seed = meadow.seed;
  strip.tile_m = kCellsPerSide * meadow.tile_m;
  strip.extent_m = glm::dvec2(strip.tile_m);
  PlantedSpecies planted;
  planted.species.params = species;
  const float width_m = std::max(species.width_m, kLeastTexels * texel_m);
  planted.species.params.width_m = width_m;
  planted.density_per_m2 = NodeGrid::uniform(0.25f * species.densest_per_m2 * species.width_m / width_m);
  strip.species.push_back(std::move(planted));
  return strip;
}

FramePlan plan_of(const Meadow& strip, std::uint32_t species, float all_per_m2) {
  FramePlan plan;
  plan.camera.orthographic_height_m = 1.0;
  plan.lod = tier_coefficients(Tier::kHermite, Quality::kHigh, 1.0, plan.camera);
  CellTables tables;
  append_cell(strip, PlantingLattice(strip), {0, 0}, 0, tables);
  if (tables.cells.empty()) return plan;
  DrawnCell cell{};
  cell.planted = tables.cells.front();
  // The light in it is that of the whole sward.
  cell.planted.other_density_per_m2 =
      std::max(all_per_m2 - strip.species[0].density_per_m2.sample({0.0, 0.0}), 0.0f);
  cell.planted.species = species;
  cell.drawn = cell.planted.planted;
  plan.cells.push_back(cell);
  plan.groups.push_back({false, kSegments, 0, 1});
  plan.tables = tables.tables;
  plan.blades_drawn = cell.drawn;
  return plan;
}

}  // namespace

StripPainter::StripPainter(const World& world, const std::filesystem::path& shader_folder)
    : world_(&world),
      program_(make_program(shader_folder, {"pass/strip_blade.vert", "pass/strip_blade.frag"})) {}

GlTexture StripPainter::paint(StreamBuffer& stream, BladePass& blades, const FrameParams& light,
                              std::span<const SpeciesParams> species, std::vector<StripTraits>& traits) {
  traits.assign(species.size(), {});
  const Meadow& meadow = world_->meadow();
  const int layers = kStripFacings * static_cast<int>(species.size());
  const int levels = std::bit_width(static_cast<unsigned>(kStripColumns));
  GlTexture texture = make_texture(GL_TEXTURE_2D_ARRAY);
  glTextureStorage3D(texture.get(), levels, GL_RGBA8, kStripColumns, kStripRows, layers);
  glTextureParameteri(texture.get(), GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glTextureParameteri(texture.get(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_S, GL_REPEAT);
  glTextureParameteri(texture.get(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);

  GlTexture color = make_texture(GL_TEXTURE_2D);
  GlTexture depth = make_texture(GL_TEXTURE_2D);
  GlFramebuffer framebuffer = make_framebuffer();
  glTextureStorage2D(color.get(), 1, GL_RGBA32F, kStripColumns, kStripRows);
  glTextureStorage2D(depth.get(), 1, GL_DEPTH_COMPONENT32F, kStripColumns, kStripRows);
  glNamedFramebufferTexture(framebuffer.get(), GL_COLOR_ATTACHMENT0, color.get(), 0);
  glNamedFramebufferTexture(framebuffer.get(), GL_DEPTH_ATTACHMENT, depth.get(), 0);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.get());
  glViewport(0, 0, kStripColumns, kStripRows);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);

  float all_per_m2 = 0.0f;
  for (const SpeciesParams& params : species) all_per_m2 += params.densest_per_m2;
  std::vector<SpeciesParams> widened(species.begin(), species.end());
  GlBuffer frame_block;
  for (std::uint32_t s = 0; s < species.size(); ++s) {
    const Meadow strip = strip_meadow(meadow, species[s], static_cast<float>(meadow.tile_m) / kStripColumns);
    widened[s] = strip.species[0].species.params;
    const FramePlan plan = plan_of(strip, s, all_per_m2);
    const float longest_m = species[s].height_m * (1.0f + layouts::kTallestSpread * species[s].height_spread);
    for (int facing = 0; facing < kStripFacings; ++facing) {
      FrameParams frame = light;
      frame.parallel = 1.0f;
      frame.towards_eye = kFacing[facing].towards_eye;
      frame.lod = plan.lod;
      frame.lod_eye_m = glm::vec3(0.0f);
      frame.tint = 0.0f;
      frame.haze_per_m = 0.0f;
      frame.strip_height_m = longest_m;
      frame_block.upload(&frame, sizeof(frame));
      glBindBufferBase(GL_UNIFORM_BUFFER, 0, frame_block.get());
      const float nothing[4] = {0.0f, 0.0f, 0.0f, 1.0f};
      const float far = 0.0f;
      glClearNamedFramebufferfv(framebuffer.get(), GL_COLOR, 0, nothing);
      glClearNamedFramebufferfv(framebuffer.get(), GL_DEPTH, 0, &far);
      stream.begin_frame();
      blades.prepare(stream, plan, widened);
      glProgramUniform1ui(program_.get(), 0, BladePass::vertices_per_blade(kSegments));
      glProgramUniform1f(program_.get(), 1, static_cast<float>(plan.blades_drawn));
      glProgramUniform3fv(program_.get(), 3, 1, &kFacing[facing].along[0]);
      for (const float shift : {-frame.tile_m, 0.0f, frame.tile_m}) {
        glProgramUniform1f(program_.get(), 2, shift);
        blades.draw(stream, program_.get());
      }
      StripDrawing drawing{kStripColumns, kStripRows, {}};
      drawing.rgba.resize(std::size_t{4} * kStripColumns * kStripRows);
      glGetTextureImage(color.get(), 0, GL_RGBA, GL_FLOAT,
                        static_cast<GLsizei>(drawing.rgba.size() * sizeof(float)), drawing.rgba.data());
      traits[s].standing_share = std::max(traits[s].standing_share, standing_share(drawing));
      const std::vector<StripLevel> drawn_levels = strip_levels(drawing);
      for (int level = 0; level < levels; ++level) {
        const StripLevel& drawn = drawn_levels[level];
        glTextureSubImage3D(texture.get(), level, 0, 0, static_cast<int>(s) * kStripFacings + facing,
                            drawn.columns, drawn.rows, 1, GL_RGBA, GL_UNSIGNED_BYTE, drawn.rgba.data());
      }
    }
    widened[s] = species[s];
    traits[s].tip_share = tip_share(species[s]);
  }
  return texture;
}

}  // namespace prairie
