// The pixels of a frame as a picture: right way up, and developed as render/post/develop.h does it.
#pragma once

#include <glm/vec2.hpp>
#include <span>

#include "pictures/picture.h"

namespace prairie {

/// `rgba`: linear radiance and cover, rows from the bottom.
Picture developed_picture(glm::ivec2 size_px, std::span<const float> rgba, float exposure);

}  // namespace prairie
