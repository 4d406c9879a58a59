#version 450 core
// The flat tier (G03 §3.5): the floor between blades, and the sward's look from afar
// (lod/sward/sward_response.h) as far as the tiers above do not show it: what blades and strips leave
// uncovered of the cover that all blades would have. Alpha holds that cover.
#include "shaders/lib/layouts.glsl"
#include "shaders/lib/frame_blocks.glsl"

vec4 table_texel(uint texel) {
  return vec4(0.0f);
}
#include "shaders/lib/kernels.glsl"
#include "shaders/lib/haze.glsl"
#include "shaders/lib/tint.glsl"
#include "shaders/lib/value_noise.glsl"
#include "shaders/lib/litter.glsl"

#include "shaders/lib/flat_map.glsl"
#include "shaders/shared/tile_morphs.glsl"

layout(binding = kTileMorphUnit) uniform sampler2D tile_morphs;

layout(location = 0) in vec3 from_eye_m;
layout(location = 1) in vec3 ground_normal;
layout(location = 2) in vec3 sward_radiance;
layout(location = 3) in float depth_per_leaf_area;
layout(location = 4) in vec4 haze_color_and_share;
layout(location = 5) in vec4 above;
#ifdef CONDITIONED
layout(location = 6) in vec3 color_factor;
#endif
layout(location = 0) out vec4 color;

// The flat map over a pixel's long, narrow footprint, as over a square of the same area: neither does it
// flicker nor is it blurred to a band. Anisotropic filters differ between devices, and Mesa's software
// renderer walks every texel of a footprint, which takes seconds where ground is seen edge-on.
vec4 flat_map_over_footprint(vec2 uv) {
  vec2 texels = vec2(textureSize(flat_map, 0));
  vec2 dx = dFdx(uv) * texels;
  vec2 dy = dFdy(uv) * texels;
  return textureLod(flat_map, uv, 0.25 * log2(max(dot(dx, dx) * dot(dy, dy), 1.0e-12)));
}

// Strips leave gaps: what is seen between them is not the floor but more grass. Chosen for the least change
// of cover along the border sequences (bench/tier_borders.cpp).
const float kSureOfStrips = 0.65;

// How far the tile at this pixel has morphed, as planned: its blades and strips stand by its middle.
// `unplanned`: where the plan does not tell.
float tile_morph(float unplanned) {
  ivec2 tile = ivec2(floor((from_eye_m.xy + view.eye_in_tile_m) / field.tile_m)) + kTileMorphSide / 2;
  if (any(lessThan(tile, ivec2(0))) || any(greaterThanEqual(tile, ivec2(kTileMorphSide)))) return unplanned;
  float steps = 255.0 * texelFetch(tile_morphs, tile, 0).r;
  return steps <= kTileMorphSteps + 0.5 ? steps / kTileMorphSteps : unplanned;
}

// What stands in the tiers above: the shares of the optical depth that blades and strips have, how far a line
// of sight goes on below the tops of strips, and how far the feet of blades have slid to their rows. `above`
// (shaders/pass/ground.vert) holds the first three for tiles of blades alone, of strips alone, and of either,
// and the morph of tiles that are not planned.
vec4 standing_above(vec4 above) {
  float morph = tile_morph(above.w);
  float grown = strips_grown(morph);
  float left = blades_left(morph);
  float slid = feet_slid(morph);
  return vec4(above.x * left, above.y * grown, above.z * max(grown, slid * left), slid);
}

// What the tiers above leave of the sward's cover to the ground. Feet that have slid by s have left a square
// of side s in the middle of their tile; the rows of strips stand along its edges. A line of sight, which is
// below the tops of blades as far as `reach`, stays within that square and meets nothing, or meets the blades
// around it, and where it leaves the tile a row. Blades that have slid hide one another: their share falls as
// (1 − s)².
float cover_left(float optical_depth, vec4 standing, vec2 level_to_eye) {
  vec2 reach = level_to_eye * standing.z / field.tile_m;
  vec2 from = (from_eye_m.xy + view.eye_in_tile_m) / field.tile_m;
  vec2 tile = floor(from);
  vec2 far_off = max(abs(from - tile - 0.5), abs(from + reach - tile - 0.5));  // from the tile's middle
  bool is_clear = max(far_off.x, far_off.y) < 0.5 * standing.w;
  bool crosses = max(far_off.x, far_off.y) > 0.5;
  vec2 free = max(vec2(standing.w) - abs(reach), vec2(0.0));
  float meeting = max(1.0 - free.x * free.y, 1.0e-3);  // the share of lines that meet blades
  float crossing = clamp(abs(reach.x) + abs(reach.y), 1.0e-4, 1.0);
  float kept = 1.0 - standing.w;
  float blades = optical_depth * standing.x * kept * kept;
  float bare = is_clear ? 1.0 : exp(-blades / meeting);
  if (crosses) bare *= 1.0 - kSureOfStrips * (1.0 - exp(-standing.y * optical_depth / crossing));
  return clamp(1.0 - exp(-optical_depth) / max(bare, 1.0e-6), 0.0, 1.0);
}

// Beyond the field there is nothing but its look.
bool is_planted(vec2 place_m) {
  return all(greaterThanEqual(place_m, field.planted_m.xy)) &&
         all(lessThanEqual(place_m, field.planted_m.zw));
}

void main() {
  vec2 place_m = ground_place_m(from_eye_m);
  vec4 grass = flat_map_over_footprint(flat_map_place(from_eye_m));
#ifdef CONDITIONED
  grass.rgb *= color_factor;
#endif

  float grain = 0.65 * filtered_noise(place_m * 9.0) + 0.35 * filtered_noise(place_m * 37.0);
  float patchy = filtered_noise(place_m * 0.9);

  vec3 normal = normalize(ground_normal);
  float leaf_area = leaf_area_of(grass.a);
  float optical_depth = leaf_area * depth_per_leaf_area;
  vec3 sward = sward_radiance * grass.rgb / field.mean_albedo;
  sward *= (0.8 + 0.4 * patchy) * (0.7 + 0.6 * grain);

  // Between blades: soil, and dead leaves in the sward's shade.
  float n_dot_l = dot(normal, light.sun_direction);
  vec3 soil_albedo = field.soil_color * (0.6 + 0.8 * grain);
  vec3 soil = soil_albedo * (light.top_ambient + light.sun_radiance * max(n_dot_l, 0.0));
  vec3 floor_of_sward =
      mix(soil, litter_radiance(grass.rgb) * (0.55 + 0.9 * grain), smooth_ramp(1.6 * grass.a));

  vec3 to_eye = view.parallel > 0.5 ? view.towards_eye : -from_eye_m;
  vec4 standing = is_planted(place_m) ? standing_above(above) : vec4(0.0);
  float cover =
      cover_left(optical_depth, standing, to_eye.xy * inversesqrt(max(dot(to_eye.xy, to_eye.xy), 1.0e-12)));
  Haze haze;
  haze.color = haze_color_and_share.rgb;
  haze.share = haze_color_and_share.a;
  color = vec4(hazed(mix(floor_of_sward, tinted_tier(sward, kFlatTint), cover), haze), cover);
}
