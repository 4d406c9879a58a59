#version 450 core
// The sky behind everything: a gradient from zenith to horizon, the sun's glow, a few clouds
// (shaders/pass/sky_map.frag).
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

layout(binding = kSkyMapUnit) uniform sampler2D sky_map;
layout(location = kSkyDirections) uniform mat3
    scene_from_view;  // columns: right · aspect · tan, up · tan, forward
layout(location = 0) in vec2 clip_xy;
layout(location = 0) out vec4 color;

void main() {
  if (view.parallel > 0.5) {
    color = vec4(light.horizon_radiance, 0.0);
    return;
  }
  vec3 direction = scene_from_view * vec3(clip_xy, 1.0);
  direction.z = max(direction.z, 0.0);
  direction *= inversesqrt(dot(direction, direction));
  color = vec4(textureLod(sky_map, direction.xy / (1.0 + direction.z) * 0.5 + 0.5, 0.0).rgb, 0.0);
}
