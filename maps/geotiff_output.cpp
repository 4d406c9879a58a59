#include "maps/geotiff_output.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal.h>

#include <atomic>
#include <cassert>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "files/error.h"
#include "maps/georaster/gdal_session.h"

namespace prairie {
namespace {

constexpr float kNodata = -9999.0f;

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using OpenDataset = std::unique_ptr<void, CloseDataset>;

/// A file in GDAL's memory, under a name of its own.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<int> count = 0;
    name_ = fmt::format("/vsimem/prairie-{}.tif", count++);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name_.c_str()); }

  const char* name() const { return name_.c_str(); }
  std::vector<std::byte> bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, 0);
    std::vector<std::byte> result(data != nullptr ? size : 0);
    if (data != nullptr) std::memcpy(result.data(), data, result.size());
    return result;
  }

 private:
  std::string name_;
};

OpenDataset create(const MemoryFile& file, const GridFrame& frame) {
  constexpr const char* kOptions[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "BLOCKYSIZE=64", nullptr};
  GDALDriverH driver = GDALGetDriverByName("GTiff");
  return OpenDataset(GDALCreate(driver, file.name(), frame.columns, frame.rows, 1, GDT_Float32,
                                const_cast<char**>(kOptions)));
}

bool set_place(GDALDatasetH dataset, const GridFrame& frame, const GeoReference* geo_reference) {
  const double pixel_m = geo_reference != nullptr ? geo_reference->pixel_size_m : frame.spacing_m;
  const double west_m = geo_reference != nullptr ? geo_reference->west_m : frame.origin_m.x;
  const double south_m = geo_reference != nullptr ? geo_reference->south_m : frame.origin_m.y;
  double place[6] = {
      west_m - 0.5 * pixel_m, pixel_m, 0.0, south_m + (frame.rows - 0.5) * pixel_m, 0.0, -pixel_m};
  if (GDALSetGeoTransform(dataset, place) != CE_None) return false;
  return geo_reference == nullptr || geo_reference->wkt.empty() ||
         GDALSetProjection(dataset, geo_reference->wkt.c_str()) == CE_None;
}

bool write_rows(GDALRasterBandH band, const NodeGrid& grid) {
  const GridFrame& frame = grid.frame();
  std::vector<float> row(static_cast<std::size_t>(frame.columns));
  for (int j = 0; j < frame.rows; ++j) {
    grid.read_block({0, frame.rows - 1 - j, frame.columns, 1}, row);
    for (float& value : row) {
      if (std::isnan(value)) value = kNodata;
    }
    if (GDALRasterIO(band, GF_Write, 0, j, frame.columns, 1, row.data(), frame.columns, 1, GDT_Float32, 0,
                     0) != CE_None)
      return false;
  }
  return true;
}

}  // namespace

std::vector<std::byte> encode_geotiff(const NodeGrid& grid, const GeoReference* geo_reference) {
  assert(grid.channels() == 1 && !grid.is_uniform());
  GdalSession session;
  const MemoryFile file;
  OpenDataset dataset = create(file, grid.frame());
  GDALRasterBandH band = dataset != nullptr ? GDALGetRasterBand(dataset.get(), 1) : nullptr;
  const bool is_written = band != nullptr && set_place(dataset.get(), grid.frame(), geo_reference) &&
                          GDALSetRasterNoDataValue(band, static_cast<double>(kNodata)) == CE_None &&
                          write_rows(band, grid);
  dataset.reset();  // writes what is still to be written
  if (const std::string error = session.take_error(); !is_written || !error.empty())
    throw OutputFailure("", "", error, "a GeoTIFF encoded in memory");
  return file.bytes();
}

}  // namespace prairie
