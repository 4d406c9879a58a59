// Draws the strips' texture (lod/sward/strip_texture.h) with the renderer's own blades, on level ground in
// the scene's light.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "render/gl/gl_objects.h"
#include "render/gl/stream_buffer.h"
#include "render/grass/blade_pass.h"
#include "render/grass/strip_pass.h"
#include "world/world.h"

namespace prairie {

class StripPainter {
 public:
  StripPainter(const World& world, const std::filesystem::path& shader_folder);

  /// An array texture of kStripFacings layers a species. `light`: a frame block of the scene; overwrites the
  /// bound one. The sward's tables must be bound. `traits`: of each species' strips, with the longest blade's
  /// length for the height of its texture.
  GlTexture paint(StreamBuffer& stream, BladePass& blades, const FrameParams& light,
                  std::span<const SpeciesParams> species, std::vector<StripTraits>& traits);

 private:
  const World* world_;
  GlProgram program_;
};

}  // namespace prairie
