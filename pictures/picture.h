// A picture as it was drawn: in linear light, and as an 8-bit picture shows it.
#pragma once

#include <cstdint>
#include <vector>

namespace prairie {

struct Picture {
  int width = 0;
  int height = 0;
  std::vector<float> linear_rgb;   // rows from the top
  std::vector<std::uint8_t> srgb;  // the same, exposed, tone-mapped, sRGB-encoded
  std::vector<float> cover;        // share of each pixel that shows grass
};

}  // namespace prairie
