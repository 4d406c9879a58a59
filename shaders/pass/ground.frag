#version 450 core
// The flat tier (G03 §3.5): the floor between blades, and the sward's look from afar (render/sward_response.h) as far as the
// tiers above do not show it: what blades and strips leave uncovered of the cover that all blades would have. Alpha holds that
// cover.
#include "shaders/pass/layouts.glsl"
#include "shaders/pass/frame_block.glsl"

vec4 table_texel(uint texel) { return vec4(0.0f); }
#include "shaders/pass/kernels.glsl"
#include "shaders/pass/haze.glsl"
#include "shaders/pass/sward_look.glsl"
#include "shaders/pass/tint.glsl"
#include "shaders/pass/value_noise.glsl"

layout(binding = 0) uniform sampler2D flat_map;  // rgb: mean albedo of the blades, a: the ground they cover

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 ground_normal;
layout(location = 0) out vec4 color;

// The flat map over a pixel's long, narrow footprint: four places along it, each with the footprint's width as its own.
// Done here rather than by anisotropic filters: they differ between devices, and Mesa's software renderer walks every
// texel of a footprint, which takes seconds where ground is seen edge-on.
vec4 flat_map_over_footprint(vec2 uv) {
  vec2 across = dFdx(uv);
  vec2 along = dFdy(uv);
  if (dot(across, across) > dot(along, along)) {
    vec2 other = across;
    across = along;
    along = other;
  }
  vec4 sum = vec4(0.0);
  for (int n = 0; n < 4; ++n) {
    sum += textureGrad(flat_map, uv + along * ((float(n) + 0.5) / 4.0 - 0.5), across, along * 0.25);
  }
  return 0.25 * sum;
}

// The share of the line of sight's pixels that strips cover. Rows of them stand `frame.tile_m` apart both ways; where less than
// one is met on the way through the sward, the ground is seen between them.
float covered_by_strips(float optical_depth, float grown, vec3 to_eye, float sin_elevation) {
  float level = sqrt(max(1.0 - sin_elevation * sin_elevation, 1.0e-6));
  float rows_per_m = (abs(to_eye.x) + abs(to_eye.y)) / (level * frame.tile_m);
  float rows = max(frame.strip_height_m * grown * rows_per_m * level / sin_elevation, 1.0e-4);
  float met = min(rows, 1.0);
  return met * (1.0 - exp(-grown * optical_depth / met));
}

// What the tiers above leave of `optical_depth`'s cover to the ground.
float cover_left(float optical_depth, float n_dot_r, float pixel_m, float distance_m, vec3 to_eye, float sin_elevation) {
  float morph = strip_morph(frame.lod, strip_band(frame.lod, distance_m), n_dot_r);
  float keep = keep_share(frame.lod, n_dot_r, pixel_m, distance_m);
  float area = min(area_left(frame.lod, keep) * max(frame.lod.widest_pixels * pixel_m / frame.blade_width_m, 1.0), 1.0);
  float bare_of_blades = exp(-optical_depth * area * blades_left(morph));
  float grown = strips_grown(morph) * (1.0 - sunk_share(frame.lod, distance_m));
  float bare = bare_of_blades * (1.0 - covered_by_strips(optical_depth, grown, to_eye, sin_elevation));
  return clamp(1.0 - exp(-optical_depth) / max(bare, 1.0e-6), 0.0, 1.0);
}

void main() {
  vec2 place_m = frame.anchor_m + (from_eye_m.xy - frame.ground_from_eye_m.xy);
  vec2 period_m = vec2(frame.flat_period_x_m, frame.flat_period_y_m);
  vec4 grass = flat_map_over_footprint(place_m / period_m + 0.5 / vec2(textureSize(flat_map, 0)));

  float distance_m = length(from_eye_m);
  float detail = frame.parallel > 0.5 ? 1.0 : saturate(1.5 - distance_m / 60.0);
  float grain = mix(0.5, 0.65 * value_noise(place_m * 9.0) + 0.35 * value_noise(place_m * 37.0), detail);
  float patchy = value_noise(place_m * 0.9);

  vec3 normal = normalize(ground_normal);
  vec3 to_eye = frame.parallel > 0.5 ? frame.towards_eye : -from_eye_m / max(distance_m, 1.0e-4);
  SwardView view = sward_view(normal, to_eye);
  float leaf_area = -log(1.0 - min(grass.a, 0.998)) / frame.projected_from_above;
  float optical_depth = sward_optical_depth(view, leaf_area);
  float shade = shade_of(leaf_area * frame.density_per_leaf_area, frame.shade_density_per_m2);
  vec3 sward = sward_color(kMix, view, optical_depth, shade) * grass.rgb / frame.mean_albedo;
  sward *= 0.86 + 0.28 * patchy;

  // Between blades: soil, and dead leaves in the sward's shade.
  float n_dot_l = dot(normal, frame.sun_direction);
  vec3 soil_albedo = frame.soil_color * (0.6 + 0.8 * grain);
  vec3 soil = soil_albedo * (frame.top_ambient + frame.sun_radiance * max(n_dot_l, 0.0));
  vec3 litter = mix(grass.rgb, vec3(0.10, 0.085, 0.04), 0.3) * (0.55 + 0.9 * grain);
  vec3 floor_of_sward = mix(soil, litter * (frame.root_ambient * 1.3 + 0.035 * frame.sun_radiance), smooth_ramp(1.6 * grass.a));

  vec3 from_lod_eye_m = from_eye_m - frame.lod_eye_m;
  float lod_distance_m = length(from_lod_eye_m);
  vec3 to_lod_eye = frame.parallel > 0.5 ? frame.towards_eye : -from_lod_eye_m / max(lod_distance_m, 1.0e-4);
  float pixel_m = frame.parallel > 0.5 ? frame.pixel_m : frame.pixel_m * lod_distance_m;
  float cover = cover_left(optical_depth, dot(normal, to_lod_eye), pixel_m, lod_distance_m, to_eye, view.sin_elevation);
  color = vec4(hazed(mix(floor_of_sward, tinted_tier(sward, kFlatTint), cover), haze_at(from_eye_m)), cover);
}
