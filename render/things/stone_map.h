// The look of stones as octahedral maps (shaders/lib/octahedral.glsl), painted once by
// shaders/pass/stone_map.frag.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

#include "render/gl/gl_objects.h"

namespace prairie {

struct StoneMap {
  /// As coarse as one stone needs it. A texture of one level is what a software renderer reads fastest.
  struct Level {
    GlTexture albedo;   // twice itself
    GlTexture surface;  // normal and depth of dents
  };
  std::vector<Level> levels;  // each half as wide as the one before

  /// For a stone of that radius whose pixels are so wide. The square is four radii wide in the mean.
  std::size_t level_for(double radius_m, double pixel_m) const;
};

/// Leaves depth test on, and program and vertex array changed.
StoneMap paint_stone_map(const std::filesystem::path& shader_folder, glm::vec3 mean_albedo);

}  // namespace prairie
