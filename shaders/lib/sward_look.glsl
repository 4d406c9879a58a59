// How grass looks from afar (lod/sward/sward_response.h): the colour of what one sees of its blades, and how
// much of them lies along the line of sight. Tables of the field's mix first, then of each species in it, one
// after the other in depth.
layout(binding = kSwardFreeUnit) uniform sampler3D
    sward_free;  // rgb: radiance of unshaded blades, a: leaf area seen per leaf area
layout(binding = kSwardShadedUnit) uniform sampler3D
    sward_shaded;  // rgb: of blades in the shade of a dense sward

const int kMix = 0;

struct SwardSight {
  vec2 place;  // elevation and azimuth in the tables
  float sin_elevation;
};

// Where the tables hold a line of sight (sward_place in lod/sward/sward_response.h).
float sward_elevation(float sin_elevation) {
  float lowest = sqrt(kSwardLowestSine);
  return clamp((sqrt(max(sin_elevation, 0.0)) - lowest) / (1.0 - lowest), 0.0, 1.0);
}
float sward_azimuth(float cos_azimuth_to_sun) {
  return acos(cos_azimuth_to_sun) / 3.14159265;
}
float sward_depth(float optical_depth) {
  return min(log(1.0 + optical_depth) / log(1.0 + kSwardDeepest), 1.0);
}

SwardSight sward_sight(vec3 ground_normal, vec3 to_eye) {
  SwardSight sight;
  sight.sin_elevation = max(inner(ground_normal, to_eye), kSwardLowestSine);
  float level = inversesqrt(
      max(dot(to_eye.xy, to_eye.xy) * dot(light.sun_direction.xy, light.sun_direction.xy), 1.0e-12));
  float cos_azimuth = clamp(dot(to_eye.xy, light.sun_direction.xy) * level, -1.0, 1.0);
  vec2 nodes = vec2(float(kSwardElevations), float(kSwardAzimuths));
  sight.place =
      (vec2(sward_elevation(sight.sin_elevation), sward_azimuth(cos_azimuth)) * (nodes - 1.0) + 0.5) / nodes;
  return sight;
}

float sward_slice(int layer, float optical_depth) {
  float slice = float(layer * kSwardDepths) + sward_depth(optical_depth) * float(kSwardDepths - 1) + 0.5;
  return slice / float(textureSize(sward_free, 0).z);
}

// Optical depth of a square metre's leaf area (m²) along the line of sight: one sees the ground with
// probability e^−depth.
float sward_optical_depth(SwardSight sight, float leaf_area) {
  float projected = textureLod(sward_free, vec3(sight.place, sward_slice(kMix, 0.0)), 0.0).a;
  return leaf_area * projected / sight.sin_elevation;
}

// `layer`: kMix, or 1 + species. `shade`: self-shading (shade_of).
vec3 sward_color(int layer, SwardSight sight, float optical_depth, float shade) {
  vec3 place = vec3(sight.place, sward_slice(layer, optical_depth));
  return mix(textureLod(sward_free, place, 0.0).rgb, textureLod(sward_shaded, place, 0.0).rgb, shade);
}

// How much brighter a sward is that leans, by `lean` as a share of its blades' length (east, north), than
// when it stood upright. Sides of leaves lie evenly around their blade, so that the sun shines on them by the
// sine of its angle to the blade; the rest of the light comes from all around.
const float kSunOfSward = 0.75;

float leaning_light(vec3 ground_normal, vec2 lean) {
  float upright = inner(ground_normal, light.sun_direction);
  float leaning = inner(normalized(ground_normal + vec3(lean, 0.0)), light.sun_direction);
  return 1.0 + kSunOfSward * (sqrt((1.05 - leaning * leaning) / (1.05 - upright * upright)) - 1.0);
}
