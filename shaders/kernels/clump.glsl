// Tufts: blades grow from a jittered lattice of plants, and those of one plant share height, lean, hue and
// dryness; blade by blade randomness alone reads as noise. A blade takes a blend of the four plants around it
// whose weights fall off steeply (a Voronoi cell with soft borders) and vanish where the four change, so that
// a root that slides a little never jumps from one tuft to the next.

struct Clump {
  float height;   // −1 … 1
  float hue;      // −1 … 1
  float dryness;  // −1 … 1
  vec2 lean;      // |each| ≤ 1
  vec2 outward;   // from the tuft's centre, in tuft distances
};

// Adds the plant at one corner of the lattice square, `corner` ∈ {0, 1}², seen from the place f in that
// square. Sums are kept in `sum`, weighted; its `weight` is their total.
struct ClumpSum {
  Clump clump;
  float weight;
};

ClumpSum add_clump(ClumpSum sum, ivec2 first, ivec2 corner, vec2 f, uint seed) {
  uint where =
      hash_u32(uint(first.x + corner.x) * 0x9e3779b9u + uint(first.y + corner.y) * 0x85ebca6bu + seed);
  uint what = where * 0xcc9e2d51u;
  what ^= what >> 15u;
  precise float away_x = f.x - (float(corner.x) - 0.3f + 0.6f * unit_from_high16(where));
  precise float away_y = f.y - (float(corner.y) - 0.3f + 0.6f * unit_from_low16(where));
  float tent_x = smooth_ramp(corner.x == 1 ? f.x : 1.0f - f.x);
  float tent_y = smooth_ramp(corner.y == 1 ? f.y : 1.0f - f.y);
  precise float closeness = 1.0f / (away_x * away_x + away_y * away_y + 0.03f);
  precise float weight = tent_x * tent_y * closeness * closeness * closeness;
  precise float height = sum.clump.height + weight * (2.0f * unit_from_byte(what >> 24u) - 1.0f);
  precise float hue = sum.clump.hue + weight * (2.0f * unit_from_byte(what >> 16u) - 1.0f);
  precise float dryness = sum.clump.dryness + weight * (2.0f * unit_from_byte(what >> 8u) - 1.0f);
  precise float lean_x = sum.clump.lean.x + weight * (2.0f * unit_from_byte(what) - 1.0f);
  precise float lean_y = sum.clump.lean.y + weight * (2.0f * unit_from_byte(where >> 4u) - 1.0f);
  precise float outward_x = sum.clump.outward.x + weight * away_x;
  precise float outward_y = sum.clump.outward.y + weight * away_y;
  ClumpSum result;
  result.clump.height = height;
  result.clump.hue = hue;
  result.clump.dryness = dryness;
  result.clump.lean = vec2(lean_x, lean_y);
  result.clump.outward = vec2(outward_x, outward_y);
  result.weight = sum.weight + weight;
  return result;
}

// The tuft at `offset` (in tuft distances) from the south-west corner of lattice square `lattice`.
Clump clump_at(ivec2 lattice, vec2 offset, uint seed) {
  precise float qx = offset.x - 0.5f;
  precise float qy = offset.y - 0.5f;
  float base_x = floor(qx);
  float base_y = floor(qy);
  precise float fx = qx - base_x;
  precise float fy = qy - base_y;
  ivec2 first = ivec2(lattice.x + int(base_x), lattice.y + int(base_y));

  ClumpSum sum;
  sum.clump.height = 0.0f;
  sum.clump.hue = 0.0f;
  sum.clump.dryness = 0.0f;
  sum.clump.lean = vec2(0.0f, 0.0f);
  sum.clump.outward = vec2(0.0f, 0.0f);
  sum.weight = 0.0f;
  sum = add_clump(sum, first, ivec2(0, 0), vec2(fx, fy), seed);
  sum = add_clump(sum, first, ivec2(1, 0), vec2(fx, fy), seed);
  sum = add_clump(sum, first, ivec2(0, 1), vec2(fx, fy), seed);
  sum = add_clump(sum, first, ivec2(1, 1), vec2(fx, fy), seed);

  precise float scale = 1.0f / (sum.weight + 1.0e-12f);
  Clump clump;
  clump.height = sum.clump.height * scale;
  clump.hue = sum.clump.hue * scale;
  clump.dryness = sum.clump.dryness * scale;
  clump.lean = vec2(sum.clump.lean.x * scale, sum.clump.lean.y * scale);
  clump.outward = vec2(sum.clump.outward.x * scale, sum.clump.outward.y * scale);
  return clump;
}
