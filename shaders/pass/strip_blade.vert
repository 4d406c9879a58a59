#version 450 core
// A vertex of a blade on its way into the strips' texture: seen from the side, blades of low rank in front.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = kStripBladeVertices) uniform uint vertices_per_blade;
layout(location = kStripBladeCount) uniform float blades;
layout(location = kStripBladeShift) uniform float shift_m;    // along the strip, which closes on itself
layout(location = kStripBladeAlong) uniform vec3 along;       // along the strip, from the viewer's left
layout(location = kStripBladeHeight) uniform float height_m;  // of the texture

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 vertex_radiance;
layout(location = 0) out vec3 radiance;
layout(location = 1) flat out float rank;

void main() {
  radiance = vertex_radiance;
  rank = (float(gl_VertexID / int(vertices_per_blade)) + 0.5) / blades;
  float x = dot(position_m, along) + shift_m;
  gl_Position = vec4(2.0 * x / field.tile_m - 1.0, 2.0 * position_m.z / height_m - 1.0, 1.0 - rank, 1.0);
}
