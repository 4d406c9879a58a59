#version 450 core
// The surface of a walker. Alpha is the cover, and no grass grows on it.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/walker_table.glsl"
#include "shaders/lib/sward_light.glsl"
#include "shaders/lib/walker_look.glsl"

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 rest_place_m;
layout(location = 3) in float open_share;
layout(location = 4) flat in uint walker_index;
layout(location = 5) flat in uint material;
layout(location = 0) out vec4 color;

void main() {
  float pixel_m = view.parallel > 0.5 ? view.pixel_m : view.pixel_m * length(from_eye_m);
  vec3 albedo = walker_albedo(walkers[walker_index], material, rest_place_m, pixel_m);
  vec3 facing = normalize(normal);
  float above_m = from_eye_m.z - walkers[walker_index].ground_from_eye_m;
  vec2 sky_and_sun = open_above(above_m, walkers[walker_index].in_sward_m) * vec2(open_share, 1.0);
  vec3 incident = solid_light(facing.z, dot(facing, light.sun_direction), sky_and_sun);
  color = vec4(hazed(albedo * incident, haze_at(from_eye_m)), 0.0);
}
