// Points of an Owen-scrambled Sobol (0,2)-sequence (Burley 2020, Practical Hash-based Owen Scrambling): every
// prefix is well spread, so drawing fewer blades is drawing a prefix (docs/design.md, D2).
//
// Scrambling works on bit-reversed words, in which a digit's permutation depends only on lower bits. The
// sequence's first dimension is the reversed index, so its reversed word is the index itself; the second
// dimension's generator is Pascal's triangle mod 2, whose reversed product with the index is five masked
// xor-shifts.

uint reverse_bits(uint x) {
  x = (x << 16u) | (x >> 16u);
  x = ((x & 0x00ff00ffu) << 8u) | ((x & 0xff00ff00u) >> 8u);
  x = ((x & 0x0f0f0f0fu) << 4u) | ((x & 0xf0f0f0f0u) >> 4u);
  x = ((x & 0x33333333u) << 2u) | ((x & 0xccccccccu) >> 2u);
  x = ((x & 0x55555555u) << 1u) | ((x & 0xaaaaaaaau) >> 1u);
  return x;
}

// A permutation in which bit b depends only on bits below it and the seed: an Owen scramble of a reversed
// word (Laine & Karras 2011, with N. Vegdahl's constants of 2021).
uint permute_upwards(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16u) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

uint sobol_reversed_second(uint index) {
  uint x = index;
  x ^= (x & 0xffff0000u) >> 16u;
  x ^= (x & 0xff00ff00u) >> 8u;
  x ^= (x & 0xf0f0f0f0u) >> 4u;
  x ^= (x & 0xccccccccu) >> 2u;
  x ^= (x & 0xaaaaaaaau) >> 1u;
  return x;
}

// Point `index` of the sequence with this seed, in [0, 1)². The second seed is hashed: the first digits of a
// scramble are its seed's lowest bits, so that with seeds that differ by a constant every odd point would
// keep to one diagonal.
vec2 sequence_point(uint index, uint seed) {
  uint x = reverse_bits(permute_upwards(index, seed));
  uint y = reverse_bits(permute_upwards(sobol_reversed_second(index), hash_u32(seed)));
  return vec2(unit_from_u32(x), unit_from_u32(y));
}
