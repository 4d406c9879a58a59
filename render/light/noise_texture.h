// White noise that closes on itself, for shaders/lib/value_noise.glsl.
#pragma once

#include "render/gl/gl_objects.h"

namespace prairie {

/// One channel, layouts::kNoiseSide texels a side, bilinear, repeating.
GlTexture make_noise_texture();

}  // namespace prairie
