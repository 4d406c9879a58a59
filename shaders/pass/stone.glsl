// A granite boulder: worn flat in places, speckled with its minerals, lichen on it. Everything is fixed to the body, so that
// one sees it roll.
#include "shaders/pass/noise_3d.glsl"

// How deep the surface lies under the sphere in a direction, 0 to 1 (w), and the slope of that (xyz). Steep between two
// levels and level on them: faces with edges rather than waves.
vec4 stone_dent(vec3 direction, uint seed) {
  vec4 sum = 0.58 * noise_and_slope(1.7 * direction, seed) * vec4(vec3(1.7), 1.0);
  sum += 0.28 * noise_and_slope(3.9 * direction, seed + 1u) * vec4(vec3(3.9), 1.0);
  sum += 0.14 * noise_and_slope(8.3 * direction, seed + 2u) * vec4(vec3(8.3), 1.0);
  const float kLow = 0.36, kHigh = 0.66;
  float t = clamp((sum.w - kLow) / (kHigh - kLow), 0.0, 1.0);
  return vec4(sum.xyz * (6.0 * t * (1.0 - t) / (kHigh - kLow)), t * t * (3.0 - 2.0 * t));
}

// How much of a pattern of this size is left to see where a pixel has that width.
float seen_share(float pattern_m, float pixel_m) { return clamp(1.6 - 2.0 * pixel_m / pattern_m, 0.0, 1.0); }

// The normal of the dented sphere, with the roughness that its mesh is too coarse for. In the body's axes.
vec3 stone_normal(vec3 direction, SolidParams solid, float pixel_m) {
  vec4 dent = stone_dent(direction, solid.seed);
  float radius_m = solid.half_size_m.x;
  vec3 slope = solid.outline_roughness * dent.xyz;
  slope += 0.13 * noise_and_slope(19.0 * direction, solid.seed + 3u).xyz * seen_share(radius_m / 19.0, pixel_m);
  // Grains stand out as far as they are large, whatever the size of the stone.
  slope += 0.16 * noise_and_slope(direction * (radius_m / 0.022), solid.seed + 4u).xyz * seen_share(0.022, pixel_m);
  slope += 0.20 * noise_and_slope(direction * (radius_m / 0.008), solid.seed + 5u).xyz * seen_share(0.008, pixel_m);
  return normalize(direction + slope - direction * dot(slope, direction));
}

vec3 stone_albedo(vec3 direction, SolidParams solid, float pixel_m) {
  float radius_m = solid.half_size_m.x;
  vec3 in_body_m = direction * radius_m;
  vec3 broad = noise_3d(2.3 * direction, solid.seed + 6u);
  vec3 patchy = noise_3d(7.0 * direction, solid.seed + 7u);
  float dent = stone_dent(direction, solid.seed).w;
  vec3 albedo = solid.albedo * (0.74 + 0.36 * broad.x + 0.24 * patchy.x) * mix(1.08, 0.80, dent);
  // Iron has run out of it here and there.
  albedo *= mix(vec3(1.0), vec3(1.10, 0.93, 0.76), smoothstep(0.55, 0.80, 0.6 * broad.y + 0.4 * patchy.y));

  // Mica, feldspar and quartz; from afar their mean.
  vec3 coarse = noise_3d(in_body_m / 0.017, solid.seed + 8u);
  vec3 fine = noise_3d(in_body_m / 0.0075, solid.seed + 9u);
  vec3 grains = mix(vec3(0.5), 0.45 * coarse + 0.55 * mix(vec3(0.5), fine, seen_share(0.0075, pixel_m)), seen_share(0.017, pixel_m));
  albedo *= 1.0 - 0.75 * smoothstep(0.60, 0.70, grains.x);
  albedo = mix(albedo, albedo * vec3(1.22, 1.0, 0.88), smoothstep(0.55, 0.66, grains.y));
  albedo = mix(albedo, vec3(0.36, 0.35, 0.33), 0.50 * smoothstep(0.60, 0.70, grains.z));

  // Lichen in crusts with ragged edges.
  vec3 ragged = noise_3d(26.0 * direction, solid.seed + 10u);
  float crust = smoothstep(0.66, 0.71, 0.62 * patchy.z + 0.28 * broad.z + 0.22 * ragged.x);
  albedo = mix(albedo, vec3(0.27, 0.29, 0.19) * (0.8 + 0.4 * ragged.y), 0.75 * crust);
  float old_crust = smoothstep(0.66, 0.70, 0.55 * patchy.y + 0.30 * broad.x + 0.30 * ragged.z);
  return mix(albedo, vec3(0.060, 0.058, 0.052), 0.6 * old_crust);
}
