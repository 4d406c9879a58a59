#version 450 core
// A vertex of the ground mesh. Positions are relative to an anchor, whole multiples of the finest quad in x
// and y, so that two patches compute the vertices of their common edge alike, bit for bit. What changes
// slowly over the ground (the sward's look from here, haze) is found here rather than for every pixel.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"
#include "shaders/shared/ground_patch.glsl"
vec4 table_texel(uint texel) {
  return vec4(0.0f);
}
#include "shaders/lib/kernels.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/sward_look.glsl"
#include "shaders/lib/flat_map.glsl"

#if defined(MOVING) || defined(CONDITIONED)
#include "shaders/lib/moving_fields.glsl"
#endif

layout(std430, binding = kThingBuffer) readonly buffer PatchTable {
  GroundPatchParams patches[];
};
layout(location = kGroundVerticesPerSide) uniform uint vertices_per_side;

layout(location = 0) in float height_m;
layout(location = 1) in vec3 normal;

layout(location = 0) out vec3 from_eye_m;
layout(location = 1) out vec3 ground_normal;
layout(location = 2) out vec3 sward_radiance;        // of the mean albedo
layout(location = 3) out float depth_per_leaf_area;  // optical depth along the line of sight
layout(location = 4) out vec4 haze_color_and_share;
layout(location = 5) out vec4 above;
#ifdef CONDITIONED
layout(location = 6) out vec3 color_factor;  // of the sward
#endif

// What stands on the ground in the tiers above, but for the tile's morph: see standing_above in
// shaders/pass/ground.frag.
vec4 tiers_above(vec3 from_eye_m, vec3 ground_normal, float sin_elevation, float density_per_m2) {
  vec3 from_lod_eye_m = from_eye_m - view.lod_eye_m;
  float distance_m = length(from_lod_eye_m);
  vec3 to_lod_eye = view.parallel > 0.5 ? view.towards_eye : -from_lod_eye_m / max(distance_m, 1.0e-4);
  float pixel_m = view.parallel > 0.5 ? view.pixel_m : view.pixel_m * distance_m;
  float n_dot_r = dot(ground_normal, to_lod_eye);
  float keep = keep_share(view.lod, n_dot_r, pixel_m, distance_m, field.blade_width_m) *
               crowded_share(view.lod, density_per_m2);
  float area =
      min(area_left(view.lod, keep) * max(view.lod.widest_pixels * pixel_m / field.blade_width_m, 1.0), 1.0);
  float level = sqrt(max(1.0 - sin_elevation * sin_elevation, 1.0e-6));
  return vec4(area, 1.0 - sunk_share(view.lod, distance_m), field.strip_height_m * level / sin_elevation,
              strip_morph(view.lod, strip_band(view.lod, distance_m), n_dot_r));
}

void main() {
  uint per_patch = vertices_per_side * vertices_per_side;
  uint slot = uint(gl_VertexID) / per_patch;
  uint vertex = uint(gl_VertexID) - slot * per_patch;
  GroundPatchParams patch_params = patches[slot];
  vec2 node = vec2(float(vertex % vertices_per_side), float(vertex / vertices_per_side));
  vec3 anchored_m = vec3(patch_params.corner_from_anchor_m + node * patch_params.quad_m, height_m);
  from_eye_m = anchored_m + view.ground_from_eye_m;
  ground_normal = normal;

  vec3 to_eye = view.parallel > 0.5 ? view.towards_eye : normalize(-from_eye_m);
  SwardSight sight = sward_sight(normalize(normal), to_eye);
  depth_per_leaf_area = sward_optical_depth(sight, 1.0);
  float leaf_area = leaf_area_of(
      textureLod(flat_map, flat_map_place(from_eye_m), log2(patch_params.quad_m / flat_texel_m())).a);
  float shade = shade_of(leaf_area * field.density_per_leaf_area, light.shade_density_per_m2);
  sward_radiance = sward_color(kMix, sight, leaf_area * depth_per_leaf_area, shade);
#ifdef MOVING
  sward_radiance *= leaning_light(normalize(normal), lean_at(from_eye_m.xy));
#endif
#ifdef CONDITIONED
  color_factor = condition_at(from_eye_m.xy).rgb;
#endif
  above = tiers_above(from_eye_m, normalize(normal), sight.sin_elevation,
                      leaf_area * field.density_per_leaf_area);
  Haze haze = haze_at(from_eye_m);
  haze_color_and_share = vec4(haze.color, haze.share);

  gl_Position = view.clip_from_eye * vec4(from_eye_m, 1.0);
  gl_Position.xy += view.jitter * gl_Position.w;
}
