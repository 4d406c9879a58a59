// The look of stones as octahedral maps (shaders/pass/octahedral.glsl), painted once by shaders/pass/stone_map.frag.
#pragma once

#include <filesystem>
#include <glm/vec3.hpp>

#include "render/gl_objects.h"

namespace prairie {

struct StoneMap {
  GlTexture albedo;   // twice itself
  GlTexture surface;  // normal and depth of dents
};

/// Leaves depth test on, and program and vertex array changed.
StoneMap paint_stone_map(const std::filesystem::path& shader_folder, glm::vec3 mean_albedo);

}  // namespace prairie
