// Radiance in one word: three small floats of 11, 11 and 10 bits, as vertex attributes of type
// GL_UNSIGNED_INT_10F_11F_11F_REV hold them.

uint small_float(float x, uint mantissa_bits) {
  uint shift = 23u - mantissa_bits;
  uint rounded = floatBitsToUint(min(max(x, 6.2e-5f), 60000.0f)) + (1u << (shift - 1u));
  return (rounded >> shift) - (112u << mantissa_bits);  // exponents count from 15 instead of 127
}

uint pack_radiance(vec3 radiance) {
  return small_float(radiance.x, 6u) | (small_float(radiance.y, 6u) << 11u) |
         (small_float(radiance.z, 5u) << 22u);
}

float from_small_float(uint bits, uint mantissa_bits) {
  return uintBitsToFloat((bits + (112u << mantissa_bits)) << (23u - mantissa_bits));
}

vec3 unpack_radiance(uint word) {
  return vec3(from_small_float(word & 2047u, 6u), from_small_float((word >> 11u) & 2047u, 6u),
              from_small_float(word >> 22u, 5u));
}
