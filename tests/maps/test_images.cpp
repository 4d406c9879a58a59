#include "tests/maps/test_images.h"

#include <tiffio.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

#include "tests/maps/geotiff_tags.h"

namespace prairie::testing {
namespace {

std::uint32_t crc32_of(std::span<const std::uint8_t> bytes) {
  std::uint32_t crc = 0xffffffffu;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

void append_be32(std::vector<std::uint8_t>* out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out->push_back(static_cast<std::uint8_t>(value >> shift));
}

void append_chunk(std::vector<std::uint8_t>* png, const std::string& type,
                  const std::vector<std::uint8_t>& data) {
  append_be32(png, static_cast<std::uint32_t>(data.size()));
  const std::size_t first = png->size();
  png->insert(png->end(), type.begin(), type.end());
  png->insert(png->end(), data.begin(), data.end());
  append_be32(png, crc32_of(std::span(*png).subspan(first)));
}

}  // namespace

template <class T>
void write_image(const std::filesystem::path& path, int width, int height, int channels,
                 OIIO::TypeDesc stored, const std::vector<T>& pixels, const OIIO::ParamValueList& attributes,
                 int tile) {
  OIIO::ImageSpec spec(width, height, channels, stored);
  spec.extra_attribs = attributes;
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (tile > 0) spec.tile_width = spec.tile_height = tile;
  const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(path.string());
  if (output == nullptr || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::BaseTypeFromC<T>::value, pixels.data()) || !output->close()) {
    throw std::runtime_error("cannot write " + path.string());
  }
}

template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<std::uint8_t>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<std::uint16_t>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<std::int16_t>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<std::uint32_t>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<std::int32_t>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<float>&, const OIIO::ParamValueList&, int);
template void write_image(const std::filesystem::path&, int, int, int, OIIO::TypeDesc,
                          const std::vector<double>&, const OIIO::ParamValueList&, int);

void write_bytes(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_bytes(path, std::as_bytes(std::span(text)));
}

std::vector<std::byte> read_bytes(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
  const std::span<const std::byte> bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

void write_geotiff(const std::filesystem::path& path, int width, int height, const GeoTiffTags& tags) {
  const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(path.c_str(), "w"), TIFFClose);
  static std::array<char, 4> name{"geo"};
  static const std::array<TIFFFieldInfo, 5> fields{{
      {geotiff::kModelPixelScale, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {geotiff::kModelTiepoint, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {geotiff::kModelTransformation, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {geotiff::kGeoKeyDirectory, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, name.data()},
      {geotiff::kGdalNodata, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name.data()},
  }};
  TIFFMergeFieldInfo(tiff.get(), fields.data(), static_cast<std::uint32_t>(fields.size()));
  TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(width));
  TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(height));
  TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 32);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
  TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
  TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  TIFFSetField(tiff.get(), TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
  TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(height));
  const auto set = [&tiff](std::uint32_t tag, const auto& values) {
    if (!values.empty()) TIFFSetField(tiff.get(), tag, static_cast<int>(values.size()), values.data());
  };
  set(geotiff::kModelPixelScale, tags.pixel_scale);
  set(geotiff::kModelTiepoint, tags.tie_points);
  set(geotiff::kModelTransformation, tags.transformation);
  set(geotiff::kGeoKeyDirectory, tags.keys);
  if (!tags.nodata.empty()) TIFFSetField(tiff.get(), geotiff::kGdalNodata, tags.nodata.c_str());
  std::vector<float> row(static_cast<std::size_t>(width), 1.0f);
  for (int j = 0; j < height; ++j)
    TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(j), 0);
}

std::vector<std::byte> png_bomb(std::uint32_t width, std::uint32_t height, bool interlaced) {
  std::vector<std::uint8_t> png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  std::vector<std::uint8_t> header;
  append_be32(&header, width);
  append_be32(&header, height);
  header.insert(header.end(), {8, 0, 0, 0, static_cast<std::uint8_t>(interlaced ? 1 : 0)});
  append_chunk(&png, "IHDR", header);
  // An empty stored deflate block.
  append_chunk(&png, "IDAT", {0x78, 0x01, 0x01, 0x00, 0x00, 0xff, 0xff, 0x00, 0x00, 0x00, 0x01});
  append_chunk(&png, "tEXt", std::vector<std::uint8_t>(270, 'x'));
  append_chunk(&png, "IEND", {});
  const std::span<const std::byte> bytes = std::as_bytes(std::span(png));
  return {bytes.begin(), bytes.end()};
}

float rolling_height_m(double x_m, double y_m) {
  double height_m = 0.0;
  double amplitude_m = 8.0;
  double wave_per_m = 0.02;
  for (int octave = 0; octave < 6; ++octave) {
    height_m += amplitude_m * std::sin(wave_per_m * x_m + 1.3 * octave) *
                std::cos(0.9 * wave_per_m * y_m + 0.7 * octave * octave);
    amplitude_m *= 0.42;
    wave_per_m *= 2.1;
  }
  return static_cast<float>(300.0 + height_m);
}

}  // namespace prairie::testing
