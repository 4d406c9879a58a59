#version 450 core
// The surface of what stands in the meadow, from its layer of the painted textures
// (pass/obstacle_texture.frag), in the light of sun, sky and the sward around. Alpha is the cover, and no
// grass grows on it.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/sward_light.glsl"

layout(binding = kObstacleAlbedoUnit) uniform sampler2DArray obstacle_albedo;
layout(binding = kObstacleSurfaceUnit) uniform sampler2DArray obstacle_surface;

layout(location = 0) in vec3 normal;
layout(location = 1) in vec3 tangent;
layout(location = 2) in vec3 on_map_above_m;
layout(location = 3) in vec3 tint;
layout(location = 4) in vec4 haze_color_and_share;
layout(location = 5) flat in float layer;
layout(location = 0) out vec4 color;

void main() {
  vec3 place = vec3(on_map_above_m.xy, layer);
  vec3 albedo = 0.5 * texture(obstacle_albedo, place).rgb * tint;
  vec4 surface = texture(obstacle_surface, place);
  vec3 bend = 2.0 * surface.xyz - 1.0;
  vec3 facing = normalize(bend.z * normal + bend.x * tangent + bend.y * cross(normal, tangent));
  // Relief catches no sun where the face that bears it is turned away.
  float sunward =
      dot(facing, light.sun_direction) * clamp(8.0 * dot(normal, light.sun_direction) + 0.2, 0.0, 1.0);
  vec2 sky_and_sun = open_above(on_map_above_m.z, max(0.9 * field.strip_height_m, 0.15));
  sky_and_sun *= vec2(surface.w, 0.5 + 0.5 * surface.w);
  vec3 incident = solid_light(facing.z, sunward, sky_and_sun);
  Haze haze;
  haze.color = haze_color_and_share.rgb;
  haze.share = haze_color_and_share.a;
  color = vec4(hazed(albedo * incident, haze), 0.0);
}
