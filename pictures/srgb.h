// The sRGB transfer function (IEC 61966-2-1), decoding; shaders/kernels/tone.glsl encodes.
#pragma once

#include <cmath>
#include <concepts>

namespace prairie {

/// `encoded`: 0…1.
template <std::floating_point Number>
Number linear_from_srgb(Number encoded) {
  if (encoded <= Number(0.04045)) return encoded / Number(12.92);
  return std::pow((encoded + Number(0.055)) / Number(1.055), Number(2.4));
}

}  // namespace prairie
