// Noise in the plane that repeats after `period` squares, for textures that do.
#include "shaders/kernels/random.glsl"

vec3 tiling_values(ivec2 node, ivec2 period, uint seed) {
  uvec3 word = hash_uvec3(uvec3((node % period + period) % period, seed));
  return vec3(word >> 8u) * (1.0 / 16777216.0);
}

float tiling_noise(vec2 p, ivec2 period, uint seed) {
  ivec2 node = ivec2(floor(p));
  vec2 f = p - vec2(node);
  vec2 t = f * f * (3.0 - 2.0 * f);
  float south =
      mix(tiling_values(node, period, seed).x, tiling_values(node + ivec2(1, 0), period, seed).x, t.x);
  float north = mix(tiling_values(node + ivec2(0, 1), period, seed).x,
                    tiling_values(node + ivec2(1, 1), period, seed).x, t.x);
  return mix(south, north, t.y);
}

// One point in each square (Worley 1996): how much nearer the nearest is than the next (x), and a value of
// its own (y).
vec2 tiling_cells(vec2 p, ivec2 period, uint seed) {
  ivec2 node = ivec2(floor(p));
  vec3 nearest = vec3(9.0, 9.0, 0.0);
  for (int n = 0; n < 9; ++n) {
    ivec2 square = node + ivec2(n % 3 - 1, n / 3 - 1);
    vec3 own = tiling_values(square, period, seed);
    float away = length(vec2(square) + 0.1 + 0.8 * own.xy - p);
    if (away < nearest.x) {
      nearest = vec3(away, nearest.x, own.z);
    } else {
      nearest.y = min(nearest.y, away);
    }
  }
  return vec2(nearest.y - nearest.x, nearest.z);
}
