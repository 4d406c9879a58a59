// A granite boulder: worn flat in places, speckled with its minerals, lichen on it. Everything is fixed to the body, so that
// one sees it roll.
#include "shaders/pass/noise_3d.glsl"

// How much of a pattern of this size is left to see where a pixel has that width.
float seen_share(float pattern_m, float pixel_m) { return clamp(1.6 - 2.0 * pixel_m / pattern_m, 0.0, 1.0); }

// The shape of a stone in a direction. Layers of noise are gone through in loops, whose body is too long to be unrolled: a
// software renderer takes a second to compile them one by one.
struct StoneShape {
  vec4 dent;  // how deep the surface lies under the sphere, 0 to 1 (w), and the slope of that (xyz)
  vec3 bump;  // slope of what the mesh is too coarse for
};

const int kDentLayers = 3;
const int kShapeLayers = 6;

StoneShape stone_shape(vec3 direction, SolidParams solid, int layers, float pixel_m) {
  float radius_m = solid.half_size_m.x;
  vec4 dent = vec4(0.0);
  vec3 bump = vec3(0.0);
  for (int n = 0; n < layers; ++n) {
    // The last two are as large as grains are, whatever the size of the stone.
    vec2 scale_and_weight = n == 0   ? vec2(1.7, 0.58)
                            : n == 1 ? vec2(3.9, 0.28)
                            : n == 2 ? vec2(8.3, 0.14)
                            : n == 3 ? vec2(19.0, 0.13)
                            : n == 4 ? vec2(radius_m / 0.022, 0.16)
                                     : vec2(radius_m / 0.008, 0.20);
    float scale = scale_and_weight.x;
    float seen = n < kDentLayers ? 1.0 : seen_share(radius_m / scale, pixel_m);
    if (seen <= 0.0) continue;
    vec4 layer = scale_and_weight.y * noise_and_slope(scale * direction, solid.seed + uint(n));
    if (n < kDentLayers) {
      dent += vec4(scale * layer.xyz, layer.w);
    } else {
      bump += seen * layer.xyz;
    }
  }
  // Steep between two levels and level on them: faces with edges rather than waves.
  const float kLow = 0.36, kHigh = 0.66;
  float t = clamp((dent.w - kLow) / (kHigh - kLow), 0.0, 1.0);
  return StoneShape(vec4(dent.xyz * (6.0 * t * (1.0 - t) / (kHigh - kLow)), t * t * (3.0 - 2.0 * t)), bump);
}

// In the body's axes.
vec3 stone_normal(vec3 direction, StoneShape shape, SolidParams solid) {
  vec3 slope = solid.outline_roughness * shape.dent.xyz + shape.bump;
  return normalize(direction + slope - direction * dot(slope, direction));
}

vec3 stone_albedo(vec3 direction, float dent, SolidParams solid, float pixel_m) {
  float radius_m = solid.half_size_m.x;
  vec3 broad = vec3(0.5), patchy = vec3(0.5), ragged = vec3(0.5), coarse = vec3(0.5), fine = vec3(0.5);
  for (int n = 0; n < 5; ++n) {
    float scale = n == 0 ? 2.3 : n == 1 ? 7.0 : n == 2 ? 26.0 : n == 3 ? radius_m / 0.017 : radius_m / 0.0075;
    vec3 noise = noise_3d(scale * direction, solid.seed + 6u + uint(n));
    if (n == 0) broad = noise;
    if (n == 1) patchy = noise;
    if (n == 2) ragged = noise;
    if (n == 3) coarse = noise;
    if (n == 4) fine = noise;
  }
  vec3 albedo = solid.albedo * (0.74 + 0.36 * broad.x + 0.24 * patchy.x) * mix(1.08, 0.80, dent);
  // Iron has run out of it here and there.
  albedo *= mix(vec3(1.0), vec3(1.10, 0.93, 0.76), smoothstep(0.55, 0.80, 0.6 * broad.y + 0.4 * patchy.y));

  // Mica, feldspar and quartz; from afar their mean.
  fine = mix(vec3(0.5), fine, seen_share(0.0075, pixel_m));
  vec3 grains = mix(vec3(0.5), 0.45 * coarse + 0.55 * fine, seen_share(0.017, pixel_m));
  albedo *= 1.0 - 0.75 * smoothstep(0.60, 0.70, grains.x);
  albedo = mix(albedo, albedo * vec3(1.22, 1.0, 0.88), smoothstep(0.55, 0.66, grains.y));
  albedo = mix(albedo, vec3(0.36, 0.35, 0.33), 0.50 * smoothstep(0.60, 0.70, grains.z));

  // Lichen in crusts with ragged edges.
  float crust = smoothstep(0.66, 0.71, 0.62 * patchy.z + 0.28 * broad.z + 0.22 * ragged.x);
  albedo = mix(albedo, vec3(0.27, 0.29, 0.19) * (0.8 + 0.4 * ragged.y), 0.75 * crust);
  float old_crust = smoothstep(0.66, 0.70, 0.55 * patchy.y + 0.30 * broad.x + 0.30 * ragged.z);
  return mix(albedo, vec3(0.060, 0.058, 0.052), 0.6 * old_crust);
}
