#version 450 core
// Paints a layer of the textures in which what stands in the meadow finds its look
// (render/things/obstacle_texture.h).
#include "shaders/shared/bindings.glsl"
#include "shaders/lib/obstacle_surface.glsl"

layout(location = kObstacleTexels) uniform float texels;  // along a side
layout(location = kObstaclePlaces) uniform
    int places;  // 7: unknown to compilers, which would make as many copies of the relief
layout(location = 0) out vec4 albedo;   // twice itself
layout(location = 1) out vec4 surface;  // the normal from -1 to 1, openness to the sky

// How much of the sky relief takes: as far as what is this far around lies higher.
const float kAroundM = 0.02;

void main() {
  vec2 at = gl_FragCoord.xy / texels;
  vec2 step_at = 1.0 / vec2(texels);
  vec2 wide = kAroundM / kMapM;
  // Here, a texel on, and around.
  float height_m[7];
  for (int n = 0; n < places; ++n) {
    int way = n - 3;
    vec2 along = n < 3 ? vec2(float(n & 1), float(n >> 1)) * step_at
                       : (way < 2 ? 1.0 : -1.0) * vec2(float(way & 1), float(1 - (way & 1))) * wide;
    height_m[n] = relief_m(at + along);
  }
  vec2 slope = (vec2(height_m[1], height_m[2]) - height_m[0]) / (step_at * kMapM);
  float around_m = 0.25 * (height_m[3] + height_m[4] + height_m[5] + height_m[6]);
  float open = clamp(1.0 - (around_m - height_m[0]) / kAroundM, 0.25, 1.0);
  albedo = vec4(2.0 * albedo_at(at, height_m[0]), 1.0);
  surface = vec4(0.5 + 0.5 * normalize(vec3(-slope, 1.0)), open);
}
