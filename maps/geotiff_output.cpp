#include "maps/geotiff_output.h"

#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>
#include <string>

#include "files/error.h"
#include "maps/geotiff_tags.h"

namespace prairie {
namespace {

constexpr float kNodata = -9999.0f;
constexpr int kRowsPerStrip = 64;

/// A file in memory as libtiff wants it.
struct MemoryFile {
  std::vector<std::byte> bytes;
  std::size_t position = 0;
  std::string error;
};

MemoryFile& file_of(thandle_t handle) {
  return *static_cast<MemoryFile*>(handle);
}

tmsize_t read_bytes(thandle_t handle, void* to, tmsize_t size) {
  MemoryFile& file = file_of(handle);
  const std::size_t left = file.position < file.bytes.size() ? file.bytes.size() - file.position : 0;
  const std::size_t count = std::min(left, static_cast<std::size_t>(size));
  std::memcpy(to, file.bytes.data() + file.position, count);
  file.position += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write_bytes(thandle_t handle, void* from, tmsize_t size) {
  MemoryFile& file = file_of(handle);
  const std::size_t end = file.position + static_cast<std::size_t>(size);
  if (end > file.bytes.size()) file.bytes.resize(end);
  std::memcpy(file.bytes.data() + file.position, from, static_cast<std::size_t>(size));
  file.position = end;
  return size;
}

toff_t seek(thandle_t handle, toff_t offset, int whence) {
  MemoryFile& file = file_of(handle);
  const std::size_t base = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? file.position : file.bytes.size();
  file.position = base + static_cast<std::size_t>(offset);
  return file.position;
}

int close_nothing(thandle_t) {
  return 0;
}

toff_t file_size(thandle_t handle) {
  return file_of(handle).bytes.size();
}

int keep_error(TIFF*, void* file, const char*, const char* format, va_list arguments) {
  std::array<char, 256> line{};
  std::vsnprintf(line.data(), line.size(), format, arguments);
  static_cast<MemoryFile*>(file)->error = line.data();
  return 1;
}

int ignore_warning(TIFF*, void*, const char*, const char*, va_list) {
  return 1;
}

void declare_geo_tags(TIFF* tiff) {
  using namespace geotiff;
  // libtiff wants names it may write to.
  static std::array<char, 4> name{"geo"};
  static const std::array<TIFFFieldInfo, 6> fields{{
      {kModelPixelScale, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {kModelTiepoint, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {kGeoKeyDirectory, -1, -1, TIFF_SHORT, FIELD_CUSTOM, 1, 1, name.data()},
      {kGeoDoubleParams, -1, -1, TIFF_DOUBLE, FIELD_CUSTOM, 1, 1, name.data()},
      {kGeoAsciiParams, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name.data()},
      {kGdalNodata, -1, -1, TIFF_ASCII, FIELD_CUSTOM, 1, 0, name.data()},
  }};
  TIFFMergeFieldInfo(tiff, fields.data(), static_cast<std::uint32_t>(fields.size()));
}

/// Writes where the raster lies: PixelIsArea, so that the tie point is the north-west corner of the first
/// pixel.
bool set_place(TIFF* tiff, const NodeGrid& grid, const GeoReference* geo_reference) {
  using namespace geotiff;
  const GridFrame& frame = grid.frame();
  const double pixel_m = geo_reference != nullptr ? geo_reference->pixel_size_m : frame.spacing_m;
  const double west_m = geo_reference != nullptr ? geo_reference->west_m : frame.origin_m.x;
  const double south_m = geo_reference != nullptr ? geo_reference->south_m : frame.origin_m.y;

  // A raster type of "point" would move the tie point by half a pixel.
  std::vector<std::uint16_t> keys{1, 1, 0, 1, kRasterTypeKey, 0, 1, kRasterPixelIsArea};
  if (geo_reference != nullptr && geo_reference->geo_keys.size() >= 4) {
    keys = geo_reference->geo_keys;
    for (std::size_t k = 4; k + 3 < keys.size(); k += 4) {
      if (keys[k] == kRasterTypeKey && keys[k + 1] == 0) keys[k + 3] = kRasterPixelIsArea;
    }
  }
  const std::array<double, 3> scale{pixel_m, pixel_m, 0.0};
  const std::array<double, 6> tie{
      0.0, 0.0, 0.0, west_m - 0.5 * pixel_m, south_m + (frame.rows - 0.5) * pixel_m, 0.0};
  bool ok = TIFFSetField(tiff, kModelPixelScale, 3, scale.data()) != 0 &&
            TIFFSetField(tiff, kModelTiepoint, 6, tie.data()) != 0 &&
            TIFFSetField(tiff, kGeoKeyDirectory, static_cast<int>(keys.size()), keys.data()) != 0;
  if (geo_reference != nullptr && !geo_reference->geo_doubles.empty()) {
    ok = ok && TIFFSetField(tiff, kGeoDoubleParams, static_cast<int>(geo_reference->geo_doubles.size()),
                            geo_reference->geo_doubles.data()) != 0;
  }
  if (geo_reference != nullptr && !geo_reference->geo_ascii.empty()) {
    ok = ok && TIFFSetField(tiff, kGeoAsciiParams, geo_reference->geo_ascii.c_str()) != 0;
  }
  return ok;
}

bool set_layout(TIFF* tiff, const GridFrame& frame) {
  return TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(frame.columns)) != 0 &&
         TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(frame.rows)) != 0 &&
         TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, 32) != 0 &&
         TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP) != 0 &&
         TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1) != 0 &&
         TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK) != 0 &&
         TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG) != 0 &&
         TIFFSetField(tiff, TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE) != 0 &&
         TIFFSetField(tiff, TIFFTAG_PREDICTOR, PREDICTOR_FLOATINGPOINT) != 0 &&
         TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(kRowsPerStrip)) != 0;
}

bool write_rows(TIFF* tiff, const NodeGrid& grid) {
  const GridFrame& frame = grid.frame();
  std::vector<float> row(static_cast<std::size_t>(frame.columns));
  for (int j = 0; j < frame.rows; ++j) {
    grid.read_block({0, frame.rows - 1 - j, frame.columns, 1}, row);
    for (float& value : row) {
      if (std::isnan(value)) value = kNodata;
    }
    if (TIFFWriteScanline(tiff, row.data(), static_cast<std::uint32_t>(j), 0) < 0) return false;
  }
  return true;
}

}  // namespace

std::vector<std::byte> encode_geotiff(const NodeGrid& grid, const GeoReference* geo_reference) {
  assert(grid.channels() == 1 && !grid.is_uniform());
  MemoryFile file;
  const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(TIFFOpenOptionsAlloc(),
                                                                                 TIFFOpenOptionsFree);
  TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, &file);
  TIFFOpenOptionsSetWarningHandlerExtR(options.get(), ignore_warning, nullptr);
  const auto fail = [&file]() { throw OutputFailure("", "", file.error, "a GeoTIFF encoded in memory"); };

  std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(
      TIFFClientOpenExt("memory.tif", "wl", &file, read_bytes, write_bytes, seek, close_nothing, file_size,
                        nullptr, nullptr, options.get()),
      TIFFClose);
  if (tiff == nullptr) fail();
  declare_geo_tags(tiff.get());
  // The nodata tag is set even where no node needs it: tags go before the rows.
  const bool ok = set_layout(tiff.get(), grid.frame()) && set_place(tiff.get(), grid, geo_reference) &&
                  TIFFSetField(tiff.get(), geotiff::kGdalNodata, fmt::format("{}", kNodata).c_str()) != 0 &&
                  write_rows(tiff.get(), grid) && TIFFWriteDirectory(tiff.get()) != 0;
  if (!ok) fail();
  tiff.reset();  // it may still move bytes about while it closes
  return std::move(file.bytes);
}

}  // namespace prairie
