#version 450 core
// Paints a layer of the textures in which what stands in the meadow finds its look (render/obstacle_texture.h).
#include "shaders/pass/obstacle_surface.glsl"

layout(location = 0) uniform float texels;  // along a side
layout(location = 0) out vec4 albedo;       // twice itself
layout(location = 1) out vec4 surface;      // the normal from -1 to 1, openness to the sky

// How much of the sky relief takes: as far as what is this far around lies higher.
const float kAroundM = 0.02;

void main() {
  vec2 at = gl_FragCoord.xy / texels;
  float here_m = relief_m(at);
  vec2 step_at = 1.0 / vec2(texels);
  vec2 slope = vec2(relief_m(at + vec2(step_at.x, 0.0)) - here_m, relief_m(at + vec2(0.0, step_at.y)) - here_m) /
               (step_at * kMapM);
  vec2 wide = kAroundM / kMapM;
  float around_m = 0.25 * (relief_m(at + vec2(wide.x, 0.0)) + relief_m(at - vec2(wide.x, 0.0)) +
                           relief_m(at + vec2(0.0, wide.y)) + relief_m(at - vec2(0.0, wide.y)));
  float open = clamp(1.0 - (around_m - here_m) / kAroundM, 0.25, 1.0);
  albedo = vec4(2.0 * albedo_at(at, here_m), 1.0);
  surface = vec4(0.5 + 0.5 * normalize(vec3(-slope, 1.0)), open);
}
