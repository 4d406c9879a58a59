// Draws the strips' texture (render/strip_texture.h) with the renderer's own blades, on level ground in the scene's light.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "render/blade_pass.h"
#include "render/gl_objects.h"
#include "render/stream_buffer.h"
#include "world/world.h"

namespace prairie {

class StripPainter {
 public:
  StripPainter(const World& world, const std::filesystem::path& shader_folder);

  /// An array texture of kStripFacings layers a species. `light`: a frame block of the scene; overwrites the bound one.
  /// The sward's tables must be bound.
  /// `standing_share`: for each species, the share of the longest blade's length up to which blades stand.
  GlTexture paint(StreamBuffer& stream, BladePass& blades, const FrameParams& light,
                  std::span<const SpeciesParams> species, std::vector<float>& standing_share);

 private:
  const World* world_;
  GlProgram program_;
};

}  // namespace prairie
