// Smooth noise in [0, 1] with one random value per unit square; for surfaces without a map of their own.
float value_noise(vec2 p) {
  vec2 cell = floor(p);
  vec2 f = p - cell;
  f = f * f * (3.0 - 2.0 * f);
  ivec2 i = ivec2(cell);
  vec4 v;
  for (int n = 0; n < 4; ++n) {
    uint h = hash_u32(uint(i.x + (n & 1)) * 0x9e3779b9u ^ hash_u32(uint(i.y + (n >> 1))));
    v[n] = unit_from_u32(h);
  }
  return mix(mix(v.x, v.y, f.x), mix(v.z, v.w, f.x), f.y);
}
