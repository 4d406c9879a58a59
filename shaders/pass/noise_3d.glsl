// Smooth noise in space, from one random word per corner of the unit lattice: three independent values in [0, 1], or one with
// its slope. For solid bodies, whose surface has no map that would not be stretched somewhere.
#include "shaders/kernels/random.glsl"

// Odd numbers without a pattern in common, one for each axis and one for the seed: the words of a lattice differ by them.
const uvec3 kLatticeSteps = uvec3(2654435769u, 2246822519u, 3266489917u);
const uint kSeedStep = 668265263u;

uint lattice_word(ivec3 node, uint seed) {
  uvec3 steps = uvec3(node) * kLatticeSteps;
  return steps.x + steps.y + steps.z + seed * kSeedStep;
}

// Three values of ten bits each.
vec3 lattice_values(uint word) {
  uint random = hash_u32(word);
  return vec3(ivec3(uvec3(random, random >> 10u, random >> 20u) & 1023u)) * (1.0 / 1023.0);
}

float lattice_value(uint word) { return unit_from_u32(hash_u32(word)); }

vec3 noise_3d(vec3 p, uint seed) {
  vec3 node = floor(p);
  vec3 f = p - node;
  vec3 t = f * f * (3.0 - 2.0 * f);
  uint west = lattice_word(ivec3(node), seed), east = west + kLatticeSteps.x;
  uint north = kLatticeSteps.y, up = kLatticeSteps.z;
  vec3 low = mix(mix(lattice_values(west), lattice_values(east), t.x),
                 mix(lattice_values(west + north), lattice_values(east + north), t.x), t.y);
  vec3 high = mix(mix(lattice_values(west + up), lattice_values(east + up), t.x),
                  mix(lattice_values(west + north + up), lattice_values(east + north + up), t.x), t.y);
  return mix(low, high, t.z);
}

// xyz: slope, w: value. Fifth-order blending, so that the slope has no creases along the lattice.
vec4 noise_and_slope(vec3 p, uint seed) {
  vec3 node = floor(p);
  vec3 f = p - node;
  vec3 t = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
  vec3 dt = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  uint west = lattice_word(ivec3(node), seed), north = kLatticeSteps.y, up = kLatticeSteps.z;
  uvec4 words = uvec4(west, west + north, west + up, west + north + up);
  vec4 at_west, at_east;
  for (int n = 0; n < 4; ++n) {
    at_west[n] = lattice_value(words[n]);
    at_east[n] = lattice_value(words[n] + kLatticeSteps.x);
  }
  vec4 along_x = mix(at_west, at_east, t.x);
  vec4 step_x = at_east - at_west;
  vec2 along_y = mix(along_x.xz, along_x.yw, t.y);
  vec2 step_y = along_x.yw - along_x.xz;
  vec2 step_x_y = mix(step_x.xz, step_x.yw, t.y);
  vec3 slope = dt * vec3(mix(step_x_y.x, step_x_y.y, t.z), mix(step_y.x, step_y.y, t.z), along_y.y - along_y.x);
  return vec4(slope, mix(along_y.x, along_y.y, t.z));
}
