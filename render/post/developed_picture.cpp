#include "render/post/developed_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "shaders/kernels/kernels.h"

namespace prairie {

Picture developed_picture(glm::ivec2 size_px, std::span<const float> rgba, float exposure) {
  const auto width = static_cast<std::size_t>(size_px.x), height = static_cast<std::size_t>(size_px.y);
  assert(rgba.size() == 4 * width * height);
  Picture picture;
  picture.width = size_px.x;
  picture.height = size_px.y;
  picture.linear_rgb.resize(3 * width * height);
  picture.srgb.resize(3 * width * height);
  picture.cover.resize(width * height);
  Kernels kernels;
  for (std::size_t row = 0; row < height; ++row) {
    for (std::size_t column = 0; column < width; ++column) {
      const float* pixel = &rgba[4 * ((height - 1 - row) * width + column)];
      const std::size_t to = row * width + column;
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const float encoded = kernels.srgb_from_linear(kernels.tone_curve(exposure * pixel[channel]));
        picture.linear_rgb[3 * to + channel] = pixel[channel];
        picture.srgb[3 * to + channel] =
            static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(encoded, 0.0f, 1.0f)));
      }
      picture.cover[to] = pixel[3];
    }
  }
  return picture;
}

}  // namespace prairie
