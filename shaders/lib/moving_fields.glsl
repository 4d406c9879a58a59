// The fields around the eye that move all tiers (docs/design.md, D4): swaying (animation/sway.h), treads
// (animation/tread_window.h), and what has come over the grass (animation/condition_window.h).
layout(binding = kSwayUnit) uniform sampler2DArray sway_texels;
layout(binding = kTreadUnit) uniform sampler2DArray tread_texels;

// Where the windows hold a place: the finest one that it lies in, and the share of its period.
struct FieldPlace {
  vec2 place;
  int level;
};

const float kFadedShare = 0.9375;  // of a window's half width: fade_end_m in animation/eye_windows.h

FieldPlace field_place(vec2 from_eye_m, int levels) {
  vec2 away_m = from_eye_m - view.window_from_eye_m;
  float half_m = 0.5 * float(kSwaySide) * kSwayFinestM;
  float distance = max(abs(away_m.x), abs(away_m.y)) / (kFadedShare * half_m);
  FieldPlace found;
  found.level = int(distance >= 1.0) + int(distance >= kSwayCoarsening && levels > 2);
  float coarser =
      found.level == 0 ? 1.0 : (found.level == 1 ? kSwayCoarsening : kSwayCoarsening * kSwayCoarsening);
  // Beyond the last window a texel farther, so that no blend reaches back into it.
  float most_m = (kFadedShare * half_m + kSwayFinestM) * coarser;
  found.place = (field.window_m + clamp(away_m, -most_m, most_m)) / (2.0 * half_m * coarser);
  return found;
}

int sway_species_count() {
  return (textureSize(sway_texels, 0).z / kSwayLevels - 1) / 4;
}

// What the virtual blade of a species feels there, and how far its tip has moved.
struct Swaying {
  vec4 texel1, texel2, texel3, texel4;
};

Swaying swaying_at(vec2 from_eye_m, uint species) {
  FieldPlace found = field_place(from_eye_m, kSwayLevels);
  float layer = float(4 * (found.level * sway_species_count() + int(species)));
  Swaying swaying;
  swaying.texel1 = textureLod(sway_texels, vec3(found.place, layer), 0.0);
  swaying.texel2 = textureLod(sway_texels, vec3(found.place, layer + 1.0), 0.0);
  swaying.texel3 = textureLod(sway_texels, vec3(found.place, layer + 2.0), 0.0);
  swaying.texel4 = textureLod(sway_texels, vec3(found.place, layer + 3.0), 0.0);
  return swaying;
}

vec3 swayed_tip(Swaying swaying) {
  return vec3(swaying.texel1.w, swaying.texel2.w, swaying.texel3.w);
}

// Mean displacement of tips of all species, as a share of their length.
vec3 mean_tip_at(vec2 from_eye_m) {
  FieldPlace found = field_place(from_eye_m, kSwayLevels);
  return textureLod(sway_texels,
                    vec3(found.place, float(4 * kSwayLevels * sway_species_count() + found.level)), 0.0)
      .xyz;
}

#ifdef TRODDEN
Pressing pressing_at(vec2 from_eye_m) {
  FieldPlace found = field_place(from_eye_m, kTreadLevels);
  vec4 texel = textureLod(tread_texels, vec3(found.place, float(found.level)), 0.0);
  Pressing pressing;
  pressing.lean_rad = kTreadMostRad * texel.xy;
  pressing.tilt_rad = kTreadMostRad * texel.z;
  pressing.wear = texel.w;
  return pressing;
}

// How far tips of pressed blades lie aside, as a share of their length: a straight line for the sine of the
// tilt, up to the most there can be.
vec2 lean_of(Pressing pressing) {
  return 0.8f * pressing.lean_rad;
}
#endif

#ifdef CONDITIONED
layout(binding = kConditionUnit) uniform sampler2DArray condition_texels;

// Factors on the colour of grass there (rgb) and on its stiffness.
vec4 condition_at(vec2 from_eye_m) {
  FieldPlace found = field_place(from_eye_m, kSwayLevels);
  return textureLod(condition_texels, vec3(found.place, float(found.level)), 0.0);
}
#endif

// How far the sward leans there, as a share of its length.
vec2 lean_at(vec2 from_eye_m) {
  vec2 lean = mean_tip_at(from_eye_m).xy;
#ifdef TRODDEN
  lean += lean_of(pressing_at(from_eye_m));
#endif
  return lean;
}
