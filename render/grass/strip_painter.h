// Draws the strips' texture (lod/sward/strip_texture.h) with the renderer's own blades, on level ground in
// the scene's light: for each species and each side from which a strip is seen, a view of one cell of blades.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "lod/sward/tip_share.h"
#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/blade_pass.h"

namespace prairie {

/// What the strips of a species are like.
struct StripTraits {
  float standing_share = 0.0f;  // of the texture's height: up to where blades stand
  float reserved = 0.0f;        // fills the texel
  TipShare tip_share;           // how far wind moves its tips
};

struct StripTexture {
  GlTexture texture;  // an array of kStripFacings layers a species, each as high as the longest blade
  std::vector<StripTraits> traits;  // by species
};

/// `species`: with their greatest densities; `tile_m`, `seed`: the meadow's. The light and field blocks and
/// the sward's tables must be bound. Leaves another view block bound.
StripTexture paint_strips(StreamBuffer& stream, BladePass& blades, std::span<const SpeciesParams> species,
                          double tile_m, std::uint64_t seed, const std::filesystem::path& shader_folder);

}  // namespace prairie
