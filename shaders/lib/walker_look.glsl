// Skin, hair and clothes of a walker, by the place on the resting figure (agents/skeleton.h), metres.

// 1 within `half_width` of 0, softened over a pixel.
float stroke(float from_line, float half_width, float pixel_m) {
  float soft = max(0.5 * pixel_m, 0.0008);
  return 1.0 - smoothstep(half_width - soft, half_width + soft, abs(from_line));
}

// How much of a round spot there is; spread over a pixel where that is larger.
float spot(vec2 from_middle, vec2 half_size, float pixel_m) {
  vec2 spread = max(half_size, vec2(0.5 * pixel_m));
  float soft = clamp(0.5 * pixel_m / spread.y, 0.15, 0.8);
  float share = half_size.x * half_size.y / (spread.x * spread.y);
  return share * (1.0 - smoothstep(1.0 - soft, 1.0 + soft, length(from_middle / spread)));
}

// Height of the hairline: low at the nape, over the ears, high on the forehead.
float hairline_m(float x) {
  if (x > 0.03) return mix(1.650, 1.698, clamp((x - 0.03) / 0.05, 0.0, 1.0));
  if (x > 0.0) return mix(1.598, 1.650, x / 0.03);
  return mix(1.545, 1.598, clamp((x + 0.08) / 0.08, 0.0, 1.0));
}

vec3 head_albedo(WalkerParams walker, vec3 p, float pixel_m) {
  float soft = max(0.7 * pixel_m, 0.005);
  float hair = smoothstep(-soft, soft, p.z - hairline_m(p.x));
  vec3 skin = walker.skin;
  if (p.x > 0.05) {
    vec2 side = vec2(abs(p.y), p.z);
    float lips = spot(side - vec2(0.0, 1.5655), vec2(0.023, 0.0052), pixel_m);
    skin = mix(skin, skin * vec3(0.80, 0.52, 0.50), 0.55 * lips);
    float white = spot(side - vec2(0.0315, 1.6340), vec2(0.0135, 0.0058), pixel_m);
    float iris = spot(side - vec2(0.0310, 1.6342), vec2(0.0058, 0.0058), pixel_m);
    skin = mix(skin, vec3(0.55, 0.53, 0.50), white);
    float lid = spot(side - vec2(0.0315, 1.6400), vec2(0.0165, 0.008), pixel_m);
    float lashes = lid * stroke(side.y - 1.6400, 0.0013, pixel_m);
    skin = mix(skin, vec3(0.022, 0.018, 0.014), max(iris, 0.85 * lashes));
    float brow =
        spot(side - vec2(0.0325, 1.6545 - 0.10 * abs(side.x - 0.028)), vec2(0.0190, 0.0036), pixel_m);
    skin = mix(skin, 0.8 * walker.hair, 0.8 * brow);
    float nostril = spot(side - vec2(0.0085, 1.5930), vec2(0.0040, 0.0024), pixel_m);
    skin *= 1.0 - 0.6 * nostril;
  }
  return mix(skin, walker.hair, hair);
}

// Folds of cloth around elbows, waist, knees and ankles, −1…1: what they darken and lighten.
float folds(vec3 p, float pixel_m) {
  const float kFoldM = 0.045;
  float seen = clamp(1.5 - 3.0 * pixel_m / kFoldM, 0.0, 1.0);
  if (seen == 0.0) return 0.0;
  vec4 from_bend = (vec4(p.z) - vec4(1.08, 1.02, 0.49, 0.12)) / vec4(0.10, 0.09, 0.10, 0.07);
  vec4 near_bend = exp(-from_bend * from_bend);
  float strength = min(dot(near_bend, vec4(0.9, 0.5, 0.9, 0.8)) + 0.08, 1.0);
  float bent = 38.0 * p.y + 4.0 * sin(17.0 * p.x + 9.0 * p.z) + 3.0 * sin(31.0 * p.x - 12.0 * p.y);
  float patches = 0.5 + 0.5 * sin(29.0 * p.y + 3.0 * sin(23.0 * p.z) + 21.0 * p.x);
  float across = sin(6.2832 / kFoldM * p.z + bent), askew = sin(90.0 * p.z - 1.3 * bent);
  return seen * strength * (patches * across + 0.6 * (1.0 - patches) * askew);
}

vec3 walker_albedo(WalkerParams walker, uint material, vec3 p, float pixel_m) {
  if (material == kWalkerHead) return head_albedo(walker, p, pixel_m);
  if (material == kWalkerSkin) return walker.skin;
  if (material == kWalkerShoes) return p.z < 0.018 ? vec3(0.045, 0.042, 0.040) : walker.shoes;
  if (material == kWalkerTrousers) {
    float seam = stroke(p.x + 0.005, 0.0015, pixel_m) * min(0.003 / max(pixel_m, 0.003), 1.0);
    return walker.trousers * (1.0 - 0.35 * seam) * (1.0 + 0.13 * folds(p, pixel_m));
  }
  // The front closes along the middle; cuffs, hem and collar are hemmed.
  float line = 0.0;
  if (p.x > 0.03 && abs(p.y) < 0.1)
    line = stroke(p.y, 0.003, pixel_m) * min(0.006 / max(pixel_m, 0.006), 1.0);
  float hems =
      max(stroke(p.z - 0.862, 0.0015, pixel_m), abs(p.y) > 0.13 ? stroke(p.z - 0.868, 0.0015, pixel_m) : 0.0);
  hems *= min(0.003 / max(pixel_m, 0.003), 1.0);
  return walker.jacket * (1.0 - 0.55 * line - 0.3 * hems) * (1.0 + 0.11 * folds(p, pixel_m));
}
