#include "pictures/upright.h"

#include <algorithm>

namespace prairie {
namespace {

struct Pixel {
  int x = 0;
  int y = 0;
};

Pixel upright_pixel(const Orientation& o, Pixel stored) {
  const int right = o.stored_columns - 1, bottom = o.stored_rows - 1;
  switch (o.code) {
    case 2:
      return {right - stored.x, stored.y};
    case 3:
      return {right - stored.x, bottom - stored.y};
    case 4:
      return {stored.x, bottom - stored.y};
    case 5:
      return {stored.y, stored.x};
    case 6:
      return {bottom - stored.y, stored.x};
    case 7:
      return {bottom - stored.y, right - stored.x};
    case 8:
      return {stored.y, right - stored.x};
    default:
      return stored;
  }
}

}  // namespace

PixelRect upright_rect(const Orientation& orientation, const PixelRect& stored) {
  const Pixel a = upright_pixel(orientation, {stored.x, stored.y});
  const Pixel b = upright_pixel(orientation, {stored.x + stored.width - 1, stored.y + stored.height - 1});
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::abs(a.x - b.x) + 1, std::abs(a.y - b.y) + 1};
}

std::vector<float> upright_samples(const Orientation& orientation, const PixelRect& stored,
                                   std::span<const float> samples, int channels) {
  const PixelRect rect = upright_rect(orientation, stored);
  std::vector<float> result(samples.size());
  const float* from = samples.data();
  for (int y = 0; y < stored.height; ++y) {
    for (int x = 0; x < stored.width; ++x, from += channels) {
      const Pixel at = upright_pixel(orientation, {stored.x + x, stored.y + y});
      std::copy_n(from, channels,
                  result.data() +
                      (static_cast<std::ptrdiff_t>(at.y - rect.y) * rect.width + at.x - rect.x) * channels);
    }
  }
  return result;
}

}  // namespace prairie
