#version 450 core
// A vertex of a boulder: of the sphere that all share, put where the stone is and dented, inwards only, so
// that what treads the grass as a sphere is nowhere drawn outside it. What a software renderer would be slow
// to find for every pixel is found here: light in the axes of the stones' maps, haze, and what of the sky the
// sward leaves.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/solid_table.glsl"
#include "shaders/lib/solid_light.glsl"
#include "shaders/lib/stone_look.glsl"

layout(location = kFirstThing) uniform uint first_solid;

layout(location = 0) in vec3 place;

layout(location = 0) out vec3 on_map;
layout(location = 1) out vec4 haze_color_and_share;
layout(location = 2) out vec2 sky_and_sun;
layout(location = 3) flat out vec3 sun_on_map;
layout(location = 4) flat out vec3 up_on_map;

void main() {
  SolidParams solid = solids[first_solid + uint(gl_InstanceID)];
  mat3 body_from_scene = transpose(scene_from_body(solid));
  on_map = turned_by_seed(place, solid.seed);
  sun_on_map = turned_by_seed(body_from_scene * light.sun_direction, solid.seed);
  up_on_map = turned_by_seed(body_from_scene * vec3(0.0, 0.0, 1.0), solid.seed);
  float depth = solid.outline_roughness > 0.0 ? solid.outline_roughness * stone_dent_at(on_map) : 0.0;
  vec3 from_eye_m =
      solid.centre_from_eye_m + scene_from_body(solid) * (place * solid.half_size_m * (1.0 - depth));
  sky_and_sun = open_to_light(solid, from_eye_m);
  Haze haze = haze_at(from_eye_m);
  haze_color_and_share = vec4(haze.color, haze.share);
  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
