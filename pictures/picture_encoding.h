// Pictures as the bytes of a file: encoded in memory by OpenImageIO, since some encoders report success on a
// full disk, to be written atomically (files/atomic_file.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace prairie {

/// 8-bit sRGB RGB, rows from the top. Deterministic bytes: no clock time, no host name.
std::vector<std::byte> encode_png_rgb8(int width, int height, std::span<const std::uint8_t> rgb);
/// 8- or 16-bit grey data, rows from the top (= north).
std::vector<std::byte> encode_png_grey8(int width, int height, std::span<const std::uint8_t> grey);
std::vector<std::byte> encode_png_grey16(int width, int height, std::span<const std::uint16_t> grey);
/// Linear float RGB, rows from the top, ZIP compression.
std::vector<std::byte> encode_exr_rgb(int width, int height, std::span<const float> rgb);

}  // namespace prairie
