// The flat tier's map (lod/sward/flat_map.h) at a place on the ground.
layout(binding = kFlatMapUnit)
    uniform sampler2D flat_map;  // rgb: mean albedo of the blades, a: the ground they cover from above

vec2 ground_place_m(vec3 from_eye_m) {
  return view.anchor_m + (from_eye_m.xy - view.ground_from_eye_m.xy);
}

vec2 flat_map_place(vec3 from_eye_m) {
  vec2 period_m = field.flat_period_m;
  return ground_place_m(from_eye_m) / period_m + 0.5 / vec2(textureSize(flat_map, 0));
}

float flat_texel_m() {
  return field.flat_period_m.x / float(textureSize(flat_map, 0).x);
}

// One-sided leaf area per ground area (m²/m²).
float leaf_area_of(float cover_from_above) {
  return -log(1.0 - min(cover_from_above, 0.998)) / field.projected_from_above;
}
