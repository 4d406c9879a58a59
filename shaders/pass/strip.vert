#version 450 core
// A vertex of a strip (shaders/pass/strips.comp).
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(location = 0) in vec3 position_m;
layout(location = 1) in vec3 vertex_radiance;
layout(location = 2) in vec3 vertex_place;
layout(location = 3) in float vertex_shown;
layout(location = 0) out vec3 radiance;
layout(location = 1) out vec3 place;
layout(location = 2) out float shown;

void main() {
  radiance = vertex_radiance;
  place = vertex_place;
  shown = vertex_shown;
  gl_Position = view.clip_from_eye * vec4(position_m, 1.0f);
  gl_Position.xy += view.jitter * gl_Position.w;
}
