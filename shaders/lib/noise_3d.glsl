// Smooth noise in space, three independent values in [0, 1], from one hash per corner of the unit lattice;
// the first of them also with its slope. For solid bodies, whose surface has no map that would not be
// stretched somewhere.
#include "shaders/kernels/random.glsl"

vec3 lattice_values(ivec3 node, uint seed) {
  uvec3 word = hash_uvec3(uvec3(node) + seed * uvec3(2654435761u, 2246822519u, 3266489917u));
  return vec3(word >> 8u) * (1.0 / 16777216.0);
}

vec3 noise_3d(vec3 p, uint seed) {
  ivec3 node = ivec3(floor(p));
  vec3 f = p - vec3(node);
  vec3 t = f * f * (3.0 - 2.0 * f);
  vec3 plane[2];
  for (int z = 0; z < 2; ++z) {
    vec3 south =
        mix(lattice_values(node + ivec3(0, 0, z), seed), lattice_values(node + ivec3(1, 0, z), seed), t.x);
    vec3 north =
        mix(lattice_values(node + ivec3(0, 1, z), seed), lattice_values(node + ivec3(1, 1, z), seed), t.x);
    plane[z] = mix(south, north, t.y);
  }
  return mix(plane[0], plane[1], t.z);
}

// How much of a pattern of this size is left to see where a pixel has that width.
float seen_share(float pattern_m, float pixel_m) {
  return clamp(1.6 - 2.0 * pixel_m / pattern_m, 0.0, 1.0);
}

// xyz: slope, w: value. Fifth-order blending, so that the slope has no creases along the lattice.
vec4 noise_and_slope(vec3 p, uint seed) {
  ivec3 node = ivec3(floor(p));
  vec3 f = p - vec3(node);
  vec3 t = f * f * f * (f * (6.0 * f - 15.0) + 10.0);
  vec3 dt = 30.0 * f * f * (f * (f - 2.0) + 1.0);
  float v[8];
  for (int n = 0; n < 8; ++n) v[n] = lattice_values(node + ivec3(n & 1, (n >> 1) & 1, n >> 2), seed).x;
  vec4 along_x = mix(vec4(v[0], v[2], v[4], v[6]), vec4(v[1], v[3], v[5], v[7]), t.x);
  vec4 step_x = vec4(v[1], v[3], v[5], v[7]) - vec4(v[0], v[2], v[4], v[6]);
  vec2 along_y = mix(along_x.xz, along_x.yw, t.y);
  vec2 step_y = along_x.yw - along_x.xz;
  vec2 step_x_y = mix(step_x.xz, step_x.yw, t.y);
  vec3 slope =
      dt * vec3(mix(step_x_y.x, step_x_y.y, t.z), mix(step_y.x, step_y.y, t.z), along_y.y - along_y.x);
  return vec4(slope, mix(along_y.x, along_y.y, t.z));
}
