#version 450 core
// The sky behind everything: a gradient from zenith to horizon and the sun's glow.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"
#include "shaders/pass/haze.glsl"

layout(location = 0) uniform mat3 scene_from_view;  // columns: right · aspect · tan, up · tan, forward
layout(location = 0) in vec2 clip_xy;
layout(location = 0) out vec4 color;

void main() {
  vec3 direction = normalize(scene_from_view * vec3(clip_xy, 1.0));
  color = vec4(frame.parallel > 0.5 ? frame.horizon_radiance : sky_radiance(direction), 1.0);
}
