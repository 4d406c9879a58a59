#version 450 core
// The surface of a boulder (shaders/lib/stone.glsl), in the light of sun, sky and the sward around. Alpha is
// the cover, and no grass grows on it.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/solid_table.glsl"
#include "shaders/lib/solid_light.glsl"
#include "shaders/lib/stone_look.glsl"

layout(location = 0) in vec3 on_map;
layout(location = 1) in vec4 haze_color_and_share;
layout(location = 2) in vec2 sky_and_sun;
layout(location = 3) flat in vec3 sun_on_map;
layout(location = 4) flat in vec3 up_on_map;
layout(location = 0) out vec4 color;

void main() {
  vec2 place = octahedral_place(on_map);
  vec3 albedo = 0.5 * textureLod(stone_albedo_map, place, 0.0).rgb;
  vec3 normal = normalize(textureLod(stone_surface_map, place, 0.0).xyz - 0.5);
  vec3 incident = solid_light(dot(normal, up_on_map), dot(normal, sun_on_map), sky_and_sun);
  Haze haze;
  haze.color = haze_color_and_share.rgb;
  haze.share = haze_color_and_share.a;
  color = vec4(hazed(albedo * incident, haze), 0.0);
}
