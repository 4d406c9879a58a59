#include "pictures/picture_input.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>

#include "files/error.h"
#include "files/input_file.h"
#include "pictures/raster_file.h"
#include "pictures/srgb.h"

namespace prairie {

Picture read_picture(const std::filesystem::path& path, const std::string& field) {
  constexpr ChannelRun kRgb{0, 3};
  RasterFile file(path, field, inspect_input(path, field).bytes);
  if (file.spec().nchannels < kRgb.count)
    throw BadInput(path.string(), field, fmt::format("{} channels", file.spec().nchannels),
                   "three: red, green, blue");
  Picture picture;
  picture.width = file.columns();
  picture.height = file.rows();
  picture.linear_rgb.resize(std::size_t{3} * static_cast<std::size_t>(picture.width) *
                            static_cast<std::size_t>(picture.height));
  const bool is_srgb = file.sample_type(0).is_integer();
  if (is_srgb) picture.srgb.resize(picture.linear_rgb.size());
  file.read(kRgb, [&](const PixelRect& rect, std::span<const float> samples) {
    const auto row_values = std::size_t{3} * static_cast<std::size_t>(rect.width);
    for (std::size_t n = 0; n < samples.size(); ++n) {
      const std::size_t row = static_cast<std::size_t>(rect.y) + n / row_values;
      const std::size_t to =
          3 * (row * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(rect.x)) +
          n % row_values;
      picture.linear_rgb[to] = is_srgb ? linear_from_srgb(samples[n]) : samples[n];
      if (is_srgb) picture.srgb[to] = static_cast<std::uint8_t>(std::lround(255.0f * samples[n]));
    }
  });
  return picture;
}

}  // namespace prairie
