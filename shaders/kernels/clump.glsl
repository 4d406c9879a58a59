// Tufts: blades grow from a jittered lattice of plants, and those of one plant share height, lean, hue and dryness; blade
// by blade randomness alone reads as noise. A blade takes a blend of the four plants around it whose weights fall off
// steeply (a Voronoi cell with soft borders) and vanish where the four change, so that a root that slides a little never
// jumps from one tuft to the next.

struct Clump {
  float height;    // −1 … 1
  float hue;       // −1 … 1
  float dryness;   // −1 … 1
  vec2 lean;       // |each| ≤ 1
  vec2 outward;    // from the tuft's centre, in tuft distances
};

Clump clump_at(ivec2 lattice, vec2 offset, uint seed) {
  precise vec2 q = offset - vec2(0.5f, 0.5f);
  precise vec2 base = vec2(floor(q.x), floor(q.y));
  precise vec2 f = q - base;
  ivec2 first = lattice + ivec2(int(base.x), int(base.y));

  precise float weight_sum = 0.0f;
  precise float height = 0.0f;
  precise float hue = 0.0f;
  precise float dryness = 0.0f;
  precise vec2 lean = vec2(0.0f, 0.0f);
  precise vec2 outward = vec2(0.0f, 0.0f);
  for (int n = 0; n < 4; ++n) {
    int dx = n & 1;
    int dy = n >> 1;
    uvec3 h = hash_uvec3(uvec3(uint(first.x + dx), uint(first.y + dy), seed));
    precise vec2 centre = vec2(float(dx) - 0.3f + 0.6f * unit_from_high16(h.x), float(dy) - 0.3f + 0.6f * unit_from_low16(h.x));
    precise vec2 away = f - centre;
    precise float tent_x = smooth_ramp(dx == 1 ? f.x : 1.0f - f.x);
    precise float tent_y = smooth_ramp(dy == 1 ? f.y : 1.0f - f.y);
    precise float closeness = 1.0f / (away.x * away.x + away.y * away.y + 0.03f);
    precise float weight = tent_x * tent_y * closeness * closeness * closeness;
    weight_sum += weight;
    height += weight * (2.0f * unit_from_high16(h.y) - 1.0f);
    hue += weight * (2.0f * unit_from_low16(h.y) - 1.0f);
    dryness += weight * (2.0f * unit_from_high16(h.x ^ h.z) - 1.0f);
    lean += weight * vec2(2.0f * unit_from_high16(h.z) - 1.0f, 2.0f * unit_from_low16(h.z) - 1.0f);
    outward += weight * away;
  }
  precise float scale = 1.0f / (weight_sum + 1.0e-12f);
  Clump clump;
  clump.height = height * scale;
  clump.hue = hue * scale;
  clump.dryness = dryness * scale;
  clump.lean = lean * scale;
  clump.outward = outward * scale;
  return clump;
}
