#version 450 core
// A vertex of a blade that shaders/pass/grow.comp has grown and lit.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 vertex_radiance;
layout(location = 0) centroid out vec3 radiance;
layout(location = 1) centroid out vec2 corner_weights;
layout(location = 2) flat out vec3 corner_radiance;

void main() {
  radiance = corner_radiance = vertex_radiance;
  // The corners of a triangle are three vertices in a row.
  int corner = gl_VertexID % 3;
  corner_weights = vec2(corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0);
  gl_Position = view.clip_from_eye * vec4(position_m, 1.0f);
  gl_Position.xy += view.jitter * gl_Position.w;
}
