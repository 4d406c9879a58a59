// Cyclic gradient noise for wind (B11 §3.2: "cyclic Perlin noise texture"; Perlin 2002, Improving Noise:
// quintic weights). Deviations: gradients are unit vectors of any direction; a texture is the sum of two
// octaves, the finer half as wide and 0.6 as strong, so that three textures leave no gap in the spectrum.

// Weight between lattice nodes, t in [0, 1].
float noise_weight(float t) {
  precise float result = t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
  return result;
}

// The part of the node (i, j) in a point at `x`, `y` from it.
float noise_of_node(uint i, uint j, uint seed, float x, float y) {
  float angle = 6.2831853f * unit_from_u32(hash_uvec3(uvec3(i, j, seed)).x);
  precise float result = cosine(angle) * x + sine(angle) * y;
  return result;
}

// −0.71…0.71, of a lattice that repeats after `cells`, a power of two. `at` in cells.
float cyclic_noise(vec2 at, uint cells, uint seed) {
  float column = floor(at.x);
  float row = floor(at.y);
  precise float x = at.x - column;
  precise float y = at.y - row;
  uint west = uint(int(column)) & (cells - 1u);
  uint south = uint(int(row)) & (cells - 1u);
  uint east = (west + 1u) & (cells - 1u);
  uint north = (south + 1u) & (cells - 1u);
  float u = noise_weight(x);
  float v = noise_weight(y);
  float along_south =
      lerp(noise_of_node(west, south, seed, x, y), noise_of_node(east, south, seed, x - 1.0f, y), u);
  float along_north = lerp(noise_of_node(west, north, seed, x, y - 1.0f),
                           noise_of_node(east, north, seed, x - 1.0f, y - 1.0f), u);
  return lerp(along_south, along_north, v);
}

// Both components of T, before they are brought to unit variance. `at` in cells of the coarser octave.
vec2 wind_noise(vec2 at, uint cells, uint seed) {
  precise vec2 fine = at * 2.0f;
  precise float x = cyclic_noise(at, cells, seed) + 0.6f * cyclic_noise(fine, 2u * cells, seed + 1u);
  precise float y = cyclic_noise(at, cells, seed + 2u) + 0.6f * cyclic_noise(fine, 2u * cells, seed + 3u);
  return vec2(x, y);
}
