#version 450 core
// A vertex of a blade that shaders/pass/grow.comp has grown and lit.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 vertex_radiance;
layout(location = 0) centroid out vec3 radiance;

void main() {
  radiance = vertex_radiance;
  gl_Position = view.clip_from_eye * vec4(position_m, 1.0f);
  gl_Position.xy += view.jitter * gl_Position.w;
}
