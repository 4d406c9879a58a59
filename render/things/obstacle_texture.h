// The surfaces of what stands in the meadow: bark, worn end grain, granite, boards, dry stone, each painted
// once by shaders/pass/obstacle_texture.frag into a layer of two textures that repeat. Noise would cost a
// software renderer several times the rest of a fragment.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

#include "render/gl/gl_objects.h"

namespace prairie {

struct ObstacleTexture {
  GlTexture albedo;   // twice itself
  GlTexture surface;  // normal from -1 to 1, its z outwards, and openness to the sky
};

/// `materials`: which of the layers (by ObstacleMaterial) are needed. Throws NoSuitableOpenGl, BadInput where
/// shaders cannot be made.
ObstacleTexture paint_obstacle_texture(const std::filesystem::path& shader_folder,
                                       std::span<const bool> materials);

}  // namespace prairie
