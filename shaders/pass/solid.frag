#version 450 core
// The surface of something solid, in the light of sun, sky and the sward around: of STONE, BOARDS or a WHEEL, each a program
// of its own, for a software renderer walks through all branches. Alpha is the cover, and no grass grows on it.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"
#include "shaders/pass/haze.glsl"
#include "shaders/pass/solid_table.glsl"
#ifdef STONE
#include "shaders/pass/stone_look.glsl"
#else
#include "shaders/pass/carpentry.glsl"
#endif

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 in_body_m;
layout(location = 2) in vec3 body_normal;
layout(location = 3) flat in uint solid_index;
layout(location = 0) out vec4 color;

// What of the sky a place sees this far above the ground: blades around take most of it next to their feet.
const float kLeastSky = 0.22;
const float kLeastSun = 0.10;
// Light that sunlit grass throws up at a face that looks straight down.
const float kBounce = 0.45;

void main() {
  SolidParams solid = solids[solid_index];
  float pixel_m = frame.parallel > 0.5 ? frame.pixel_m : frame.pixel_m * length(from_eye_m);
  vec3 normal = normalize(body_normal);
  vec3 albedo = solid.albedo;
#ifdef BOARDS
  albedo = board_albedo(solid, in_body_m, normal, pixel_m);
#endif
#ifdef WHEEL
  albedo = wheel_albedo(solid, in_body_m, normal, pixel_m);
  if (albedo.r < 0.0) discard;
#endif
#ifdef STONE
  if (solid.outline_roughness > 0.0) {
    vec3 direction = normalize(in_body_m);
    vec2 place = octahedral_place(turned_by_seed(direction, solid.seed));
    float level = stone_level(solid.half_size_m.x, pixel_m);
    albedo = 0.5 * textureLod(stone_albedo_map, place, level).rgb;
    normal = normalize(turned_back(textureLod(stone_surface_map, place, level).xyz - 0.5, solid.seed));
  }
#endif
  normal = scene_from_body(solid) * normal;

  float above_m = max(from_eye_m.z - solid.ground_from_eye_m, 0.0);
  float in_sward = 1.0 - smoothstep(0.0, max(0.9 * frame.strip_height_m, 0.35 * solid.half_size_m.z), above_m);
  float sky = mix(1.0, kLeastSky, in_sward);
  vec3 ambient = sky * mix(frame.root_ambient, frame.top_ambient, 0.5 + 0.5 * normal.z);
  ambient += sky * kBounce * (0.5 - 0.5 * normal.z) * frame.mean_albedo * frame.sun_radiance * max(frame.sun_direction.z, 0.0);
  float sun = max(dot(normal, frame.sun_direction), 0.0) * mix(1.0, kLeastSun, in_sward);
  color = vec4(hazed(albedo * (ambient + sun * frame.sun_radiance), haze_at(from_eye_m)), 0.0);
}
