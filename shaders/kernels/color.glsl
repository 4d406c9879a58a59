// Colours of blades: linear RGB albedos from species, hue and dryness, and how they travel in one word.

vec3 mixed(vec3 a, vec3 b, float t) {
  return vec3(lerp(a.x, b.x, t), lerp(a.y, b.y, t), lerp(a.z, b.z, t));
}

// hue −1: darker and bluish, +1: lighter and yellowish.
vec3 tinted(vec3 green, float hue) {
  return vec3(green.x * (1.0f + 0.55f * hue), green.y * (1.0f + 0.22f * hue), green.z * (1.0f - 0.25f * hue));
}

// Drying begins at the tip.
vec3 root_albedo(SpeciesParams species, float hue, float dryness) {
  return mixed(tinted(species.root_color, hue), species.dry_color, 0.8f * dryness * dryness);
}

vec3 tip_albedo(SpeciesParams species, float hue, float dryness) {
  return mixed(tinted(species.tip_color, hue), species.dry_color, dryness);
}

// 11, 11 and 10 bits, square-root encoded: dark colours keep their steps below what an eye sees.
uint pack_color(vec3 color) {
  uint r = uint(int(sqrt(saturate(color.x)) * 2047.0f + 0.5f));
  uint g = uint(int(sqrt(saturate(color.y)) * 2047.0f + 0.5f));
  uint b = uint(int(sqrt(saturate(color.z)) * 1023.0f + 0.5f));
  return (r << 21u) | (g << 10u) | b;
}

vec3 unpack_color(uint word) {
  return vec3(square(float(int(word >> 21u)) / 2047.0f), square(float(int((word >> 10u) & 2047u)) / 2047.0f),
              square(float(int(word & 1023u)) / 1023.0f));
}
