// The blades of one quarter of a cell, so that near the eye single square metres can be culled and thinned.
//
// The first digits of a point of the sequence (shaders/kernels/sequence.glsl) say in which quarter of the
// unit square it lies: that of x is the index's lowest bit, that of y the parity of all its bits, each
// flipped by the seed. So the points of a quarter have the indices 4 i + 2 (parity(i) ⊕ c) + b, i = 0, 1, 2,
// …, and keep their ranks.

uint parity(uint x) {
  x ^= x >> 16u;
  x ^= x >> 8u;
  x ^= x >> 4u;
  x ^= x >> 2u;
  x ^= x >> 1u;
  return x & 1u;
}

// What DrawnCell::quarter holds for the quarter with x ≥ ½ (east) and y ≥ ½ (north).
uint quarter_code(uint east, uint north, uint seed) {
  uint b = (east ^ seed) & 1u;
  uint c = (north ^ hash_u32(seed) ^ b) & 1u;
  return 4u | (c << 1u) | b;
}

// Index of the i-th blade of a quarter, or of the whole cell.
uint quarter_index(uint quarter, uint i) {
  if (quarter == 0u) return i;
  uint c = (quarter >> 1u) & 1u;
  return 4u * i + 2u * (parity(i) ^ c) + (quarter & 1u);
}
