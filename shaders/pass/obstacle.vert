#version 450 core
// A vertex of what stands in the meadow (render/things/shapes/obstacle_mesh.h). Haze is found here, for a
// software renderer would be slow to find it for every pixel.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"

layout(location = kObstacleOrigin) uniform vec3 origin_from_eye_m;

layout(location = 0) in vec3 place_m;  // from the origin
layout(location = 1) in vec3 facing;
layout(location = 2) in vec3 along;
layout(location = 3) in vec3 map_and_height;
layout(location = 4) in vec4 tint_and_layer;  // 0 to 255

layout(location = 0) out vec3 normal;
layout(location = 1) out vec3 tangent;
layout(location = 2) out vec3 on_map_above_m;
layout(location = 3) out vec3 tint;
layout(location = 4) out vec4 haze_color_and_share;
layout(location = 5) flat out float layer;

void main() {
  vec3 from_eye_m = origin_from_eye_m + place_m;
  normal = facing;
  tangent = along;
  on_map_above_m = map_and_height;
  tint = tint_and_layer.rgb * (1.0 / 127.5);
  layer = tint_and_layer.a;
  Haze haze = haze_at(from_eye_m);
  haze_color_and_share = vec4(haze.color, haze.share);
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
