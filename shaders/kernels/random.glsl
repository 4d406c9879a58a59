// Counter-based random numbers: pure functions of their arguments, the same on both sides.
// Words become floats by way of int: processors convert signed words in one instruction, unsigned ones in
// many.

// Integer mixer of two multiply–xorshift rounds (C. Wellons' "lowbias32" constants; bias 0.17 of an ideal
// hash's).
uint hash_u32(uint x) {
  x ^= x >> 16u;
  x *= 0x7feb352du;
  x ^= x >> 15u;
  x *= 0x846ca68bu;
  x ^= x >> 16u;
  return x;
}

// Three independent words from three (Jarzynski & Olano 2020, Hash Functions for GPU Rendering, "pcg3d").
uvec3 hash_uvec3(uvec3 v) {
  uint x = v.x * 1664525u + 1013904223u;
  uint y = v.y * 1664525u + 1013904223u;
  uint z = v.z * 1664525u + 1013904223u;
  x += y * z;
  y += z * x;
  z += x * y;
  x ^= x >> 16u;
  y ^= y >> 16u;
  z ^= z >> 16u;
  x += y * z;
  y += z * x;
  z += x * y;
  return uvec3(x, y, z);
}

// [0, 1), 24 bits.
float unit_from_u32(uint x) {
  return float(int(x >> 8u)) * 5.9604644775390625e-8f;
}

// [0, 1), from the upper or lower 16 bits: two numbers a word where 1/65536 is fine enough.
float unit_from_high16(uint x) {
  return float(int(x >> 16u)) * 1.52587890625e-5f;
}
float unit_from_low16(uint x) {
  return float(int(x & 0xffffu)) * 1.52587890625e-5f;
}

// [0, 1), from the lowest 8 bits.
float unit_from_byte(uint x) {
  return float(int(x & 0xffu)) * 0.00390625f;
}
