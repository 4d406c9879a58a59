// Draws the sky behind everything, from a map that is made once per light.
#pragma once

#include <filesystem>

#include "lod/camera.h"
#include "render/gl/draw_state.h"
#include "render/gl/gl_objects.h"
#include "render/gl/screen_triangle.h"

namespace prairie {

class SkyPass {
 public:
  static constexpr DrawState kState{.depth_test = DepthTest::kCloserOrEqual, .writes_depth = false};

  /// Makes the map for the bound light. The noise texture must be bound.
  explicit SkyPass(const std::filesystem::path& shader_folder);

  void draw(const Camera& camera);

 private:
  GlProgram program_;
  ScreenTriangle triangle_;
  GlTexture map_;
};

}  // namespace prairie
