#version 450 core
// Paints the maps in which all stones find their look (render/things/stone_map.h).
#include "shaders/shared/bindings.glsl"
#include "shaders/lib/stone.glsl"
#include "shaders/lib/octahedral.glsl"

layout(location = kStoneTexels) uniform float texels;  // along a side
layout(location = kStoneAlbedo) uniform vec3 mean_albedo;
layout(location = 0) out vec4 albedo;           // twice itself
layout(location = 1) out vec4 normal_and_dent;  // the normal from -1 to 1

void main() {
  vec3 direction = octahedral_direction(gl_FragCoord.xy / texels);
  albedo = vec4(2.0 * stone_albedo(direction, 1u, mean_albedo), 1.0);
  normal_and_dent = vec4(0.5 + 0.5 * stone_normal(direction, 1u), stone_dent(direction, 1u).w);
}
