#version 450 core
// Paints a face of the cube maps in which all stones find their look (render/stone_map.h).
#include "shaders/pass/stone.glsl"

layout(location = 0) uniform mat3 body_from_face;
layout(location = 3) uniform float texels;  // along a side
layout(location = 4) uniform vec3 mean_albedo;
layout(location = 0) out vec4 albedo;            // twice itself
layout(location = 1) out vec4 normal_and_dent;   // the normal from -1 to 1

void main() {
  vec3 direction = normalize(body_from_face * vec3(2.0 * gl_FragCoord.xy / texels - 1.0, 1.0));
  albedo = vec4(2.0 * stone_albedo(direction, 1u, mean_albedo), 1.0);
  normal_and_dent = vec4(0.5 + 0.5 * stone_normal(direction, 1u), stone_dent(direction, 1u).w);
}
