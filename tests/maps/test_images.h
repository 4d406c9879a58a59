// Rasters that the tests make for themselves, in a folder that vanishes with the test.
#pragma once

#include <OpenImageIO/imageio.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "tests/temporary_folder.h"

namespace prairie::testing {

/// Writes pixels of type `T`, rows from the top, channels interleaved.
template <class T>
void write_image(const std::filesystem::path& path, int width, int height, int channels,
                 OIIO::TypeDesc stored, const std::vector<T>& pixels,
                 const OIIO::ParamValueList& attributes = {}, int tile = 0);

void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes);
void write_text(const std::filesystem::path& path, const std::string& text);
std::vector<std::byte> read_bytes(const std::filesystem::path& path);

/// A one-channel float GeoTIFF of all ones with tags as given; empty ones are left out.
struct GeoTiffTags {
  std::vector<double> pixel_scale = {};
  std::vector<double> tie_points = {};
  std::vector<double> transformation = {};
  std::vector<std::uint16_t> keys = {};
  std::string nodata = {};
};
void write_geotiff(const std::filesystem::path& path, int width, int height, const GeoTiffTags& tags);

/// A PNG whose header claims `width` × `height` grey pixels of 8 bits, with hardly any data behind it.
std::vector<std::byte> png_bomb(std::uint32_t width, std::uint32_t height, bool interlaced);

/// Rolling ground with detail down to a few nodes, metres.
float rolling_height_m(double x_m, double y_m);

}  // namespace prairie::testing
