// A granite boulder of radius kStoneRadiusM: worn flat in places, speckled with its minerals, lichen on it.
// Everything is fixed to the body, so that one sees it roll. Too dear to find for every pixel of a frame;
// painted once (shaders/pass/stone_map.frag).
#include "shaders/lib/noise_3d.glsl"

const float kStoneRadiusM = 0.45;
const float kStoneRoughness = 0.06;  // depth of its dents over its radius

// How deep the surface lies under the sphere in a direction, 0 to 1 (w), and the slope of that (xyz). Steep
// between two levels and level on them: faces with edges rather than waves.
vec4 stone_dent(vec3 direction, uint seed) {
  vec4 sum = 0.58 * noise_and_slope(1.7 * direction, seed) * vec4(vec3(1.7), 1.0);
  sum += 0.28 * noise_and_slope(3.9 * direction, seed + 1u) * vec4(vec3(3.9), 1.0);
  sum += 0.14 * noise_and_slope(8.3 * direction, seed + 2u) * vec4(vec3(8.3), 1.0);
  const float kLow = 0.36, kHigh = 0.66;
  float t = clamp((sum.w - kLow) / (kHigh - kLow), 0.0, 1.0);
  return vec4(sum.xyz * (6.0 * t * (1.0 - t) / (kHigh - kLow)), t * t * (3.0 - 2.0 * t));
}

// The normal of the dented sphere, with the roughness that its mesh is too coarse for. In the body's axes.
vec3 stone_normal(vec3 direction, uint seed) {
  vec3 slope = kStoneRoughness * stone_dent(direction, seed).xyz;
  slope += 0.13 * noise_and_slope(19.0 * direction, seed + 3u).xyz;
  slope += 0.16 * noise_and_slope(direction * (kStoneRadiusM / 0.022), seed + 4u).xyz;
  slope += 0.20 * noise_and_slope(direction * (kStoneRadiusM / 0.008), seed + 5u).xyz;
  return normalize(direction + slope - direction * dot(slope, direction));
}

vec3 stone_albedo(vec3 direction, uint seed, vec3 mean_albedo) {
  vec3 in_body_m = direction * kStoneRadiusM;
  vec3 broad = noise_3d(2.3 * direction, seed + 6u);
  vec3 patchy = noise_3d(7.0 * direction, seed + 7u);
  float dent = stone_dent(direction, seed).w;
  vec3 albedo = mean_albedo * (0.74 + 0.36 * broad.x + 0.24 * patchy.x) * mix(1.08, 0.80, dent);
  // Iron has run out of it here and there.
  albedo *= mix(vec3(1.0), vec3(1.10, 0.93, 0.76), smoothstep(0.55, 0.80, 0.6 * broad.y + 0.4 * patchy.y));

  // Mica, feldspar and quartz.
  vec3 coarse = noise_3d(in_body_m / 0.017, seed + 8u);
  vec3 fine = noise_3d(in_body_m / 0.0075, seed + 9u);
  vec3 grains = 0.45 * coarse + 0.55 * fine;
  albedo *= 1.0 - 0.75 * smoothstep(0.60, 0.70, grains.x);
  albedo = mix(albedo, albedo * vec3(1.22, 1.0, 0.88), smoothstep(0.55, 0.66, grains.y));
  albedo = mix(albedo, vec3(0.36, 0.35, 0.33), 0.50 * smoothstep(0.60, 0.70, grains.z));

  // Lichen in crusts with ragged edges.
  vec3 ragged = noise_3d(26.0 * direction, seed + 10u);
  float crust = smoothstep(0.66, 0.71, 0.62 * patchy.z + 0.28 * broad.z + 0.22 * ragged.x);
  albedo = mix(albedo, vec3(0.27, 0.29, 0.19) * (0.8 + 0.4 * ragged.y), 0.75 * crust);
  float old_crust = smoothstep(0.66, 0.70, 0.55 * patchy.y + 0.30 * broad.x + 0.30 * ragged.z);
  return mix(albedo, vec3(0.060, 0.058, 0.052), 0.6 * old_crust);
}
