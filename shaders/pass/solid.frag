#version 450 core
// The surface of BOARDS or a WHEEL, each a program of its own, for a software renderer walks through all
// branches. Alpha is the cover, and no grass grows on it.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/solid_table.glsl"
#include "shaders/lib/solid_light.glsl"
#include "shaders/lib/carpentry.glsl"

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 in_body_m;
layout(location = 2) in vec3 body_normal;
layout(location = 3) flat in uint solid_index;
layout(location = 0) out vec4 color;

void main() {
  SolidParams solid = solids[solid_index];
  float pixel_m = view.parallel > 0.5 ? view.pixel_m : view.pixel_m * length(from_eye_m);
  vec3 normal = normalize(body_normal);
  vec3 albedo = solid.albedo;
#ifdef BOARDS
  albedo = board_albedo(solid, in_body_m, normal, pixel_m);
#endif
#ifdef WHEEL
  albedo = wheel_albedo(solid, in_body_m, normal, pixel_m);
  if (albedo.r < 0.0) discard;
#endif
  normal = scene_from_body(solid) * normal;

  vec3 incident = solid_light(normal.z, dot(normal, light.sun_direction), open_to_light(solid, from_eye_m));
  color = vec4(hazed(albedo * incident, haze_at(from_eye_m)), 0.0);
}
