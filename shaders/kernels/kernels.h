// The kernels, read as C++ (docs/design.md, D1). They become member functions, which are inline and see the
// cell tables as the shaders see their buffer texture; a kernel that needs no tables works on `Kernels{}`.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "shaders/shared/layouts.h"

namespace prairie {

namespace kernels {
using glm::abs;
using glm::floatBitsToUint;
using glm::floor;
using glm::ivec2;
using glm::max;
using glm::min;
using glm::pow;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::uvec2;
using glm::uvec3;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = glm::uint;

#define precise  // GLSL's word for "do not rearrange"; C++ says it with -ffp-contract=off
struct Kernels {
  const float* tables = nullptr;
  vec4 table_texel(uint texel) const {
    return vec4(tables[4 * texel], tables[4 * texel + 1], tables[4 * texel + 2], tables[4 * texel + 3]);
  }

#include "shaders/kernels/random.glsl"
#include "shaders/kernels/sequence.glsl"
#include "shaders/kernels/quarter.glsl"
#include "shaders/kernels/interpolation.glsl"
#include "shaders/kernels/trigonometry.glsl"
#include "shaders/kernels/exponential.glsl"
#include "shaders/kernels/warp.glsl"
#include "shaders/kernels/clump.glsl"
#include "shaders/kernels/cell_ground.glsl"
#include "shaders/kernels/features.glsl"
#include "shaders/kernels/plant.glsl"
#include "shaders/kernels/tiers.glsl"
#include "shaders/kernels/weight.glsl"
#include "shaders/kernels/pose.glsl"
#include "shaders/kernels/pressed.glsl"
#include "shaders/kernels/hermite.glsl"
#include "shaders/kernels/chain.glsl"
#include "shaders/kernels/rotation_vector.glsl"
#include "shaders/kernels/chain_matrix.glsl"
#include "shaders/kernels/chain_motion.glsl"
#include "shaders/kernels/chain_virtual.glsl"
#include "shaders/kernels/blade_surface.glsl"
#include "shaders/kernels/color.glsl"
#include "shaders/kernels/radiance.glsl"
#include "shaders/kernels/lighting.glsl"
#include "shaders/kernels/blade_mesh.glsl"
#include "shaders/kernels/tone.glsl"
#include "shaders/kernels/tread.glsl"
#include "shaders/kernels/wind_noise.glsl"
};
#undef precise

}  // namespace kernels

using kernels::Kernels;

}  // namespace prairie
