#include "tests/maps/test_rasters.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <gdal.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <stdexcept>

#include "maps/georaster/gdal_session.h"
#include "maps/georaster/spatial_reference.h"

namespace prairie::testing {
namespace {

struct Close {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, Close>;

void require(bool condition, const std::filesystem::path& path) {
  if (!condition) throw std::runtime_error("cannot write " + path.string() + ": " + CPLGetLastErrorMsg());
}

void describe_band(GDALRasterBandH band, const RasterPlan& plan) {
  if (plan.scale_offset) {
    GDALSetRasterScale(band, (*plan.scale_offset)[0]);
    GDALSetRasterOffset(band, (*plan.scale_offset)[1]);
  }
  if (plan.nodata) GDALSetRasterNoDataValue(band, *plan.nodata);
  if (!plan.unit.empty()) GDALSetRasterUnitType(band, plan.unit.c_str());
}

void write_mask(GDALDatasetH dataset, const RasterPlan& plan) {
  GDALCreateDatasetMaskBand(dataset, GMF_PER_DATASET);
  std::vector<std::uint8_t> valid;
  for (int row = 0; row < plan.rows; ++row) {
    for (int column = 0; column < plan.columns; ++column)
      valid.push_back(plan.is_valid(column, row) ? 255 : 0);
  }
  if (GDALRasterIO(GDALGetMaskBand(GDALGetRasterBand(dataset, 1)), GF_Write, 0, 0, plan.columns, plan.rows,
                   valid.data(), plan.columns, plan.rows, GDT_Byte, 0, 0) != CE_None)
    throw std::runtime_error("no mask");
}

/// What only copies of whole rasters can be written as.
void copy_as(const std::filesystem::path& path, const std::string& driver, CPLStringList& options,
             GDALDatasetH source) {
  const Dataset copy(GDALCreateCopy(GDALGetDriverByName(driver.c_str()), path.c_str(), source, FALSE,
                                    options.List(), nullptr, nullptr));
  require(copy != nullptr, path);
}

}  // namespace

void write_georaster(const std::filesystem::path& path, const RasterPlan& plan, const StoredValue& value) {
  GDALAllRegister();
  const GdalSession session;
  CPLSetThreadLocalConfigOption("GDAL_TIFF_INTERNAL_MASK", plan.mask_is_beside ? "NO" : "YES");
  CPLStringList options;
  for (const std::string& option : plan.options) options.AddString(option.c_str());
  const bool is_made_by_copy = plan.driver != "GTiff";
  CPLStringList no_options;
  const Dataset dataset(GDALCreate(GDALGetDriverByName(is_made_by_copy ? "MEM" : "GTiff"), path.c_str(),
                                   plan.columns, plan.rows, plan.bands,
                                   GDALGetDataTypeByName(plan.type.c_str()),
                                   is_made_by_copy ? no_options.List() : options.List()));
  require(dataset != nullptr, path);
  if (plan.place) {
    MapFromPixel place = *plan.place;
    GDALSetGeoTransform(dataset.get(), place.data());
  }
  if (!plan.system.empty())
    GDALSetProjection(dataset.get(), SpatialReference::of_name(plan.system)->wkt().c_str());
  std::vector<double> row_values(static_cast<std::size_t>(plan.columns));
  for (int band = 0; band < plan.bands; ++band) {
    GDALRasterBandH handle = GDALGetRasterBand(dataset.get(), band + 1);
    describe_band(handle, plan);
    for (int row = 0; row < plan.rows; ++row) {
      for (int column = 0; column < plan.columns; ++column)
        row_values[static_cast<std::size_t>(column)] = value(column, row, band);
      require(GDALRasterIO(handle, GF_Write, 0, row, plan.columns, 1, row_values.data(), plan.columns, 1,
                           GDT_Float64, 0, 0) == CE_None,
              path);
    }
  }
  if (plan.has_mask) write_mask(dataset.get(), plan);
  if (is_made_by_copy) copy_as(path, plan.driver, options, dataset.get());
}

MapFromPixel north_up(double pixel_m, double west, double south, int rows) {
  return {west, pixel_m, 0.0, south + pixel_m * rows, 0.0, -pixel_m};
}

MapFromPixel turned(const MapFromPixel& place, double angle_rad) {
  const double c = std::cos(angle_rad), s = std::sin(angle_rad);
  return {place[0], c * place[1], -s * place[5], place[3], s * place[1], c * place[5]};
}

}  // namespace prairie::testing
