#include "maps/georaster/gdal_session.h"

#include <cpl_conv.h>
#include <cpl_error.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <ogr_srs_api.h>
#include <ogrsf_frmts.h>

#include <array>
#include <mutex>
#include <string_view>
#include <utility>

namespace prairie {
namespace {

struct Setting {
  const char* name;
  const char* value;
};

constexpr std::array kSettings{
    Setting{"GDAL_VRT_ENABLE_PYTHON", "NO"},
    Setting{"GTIFF_REPORT_COMPD_CS", "YES"},  // the height's system beside that of the plane
    Setting{"GDAL_NUM_THREADS", "4"},
    Setting{"VRT_SHARED_SOURCE", "0"},
    Setting{"OGR_GEOJSON_MAX_OBJ_SIZE", "64"},  // MB
};
constexpr GIntBig kCacheBytes = GIntBig{64} << 20;

void register_drivers() {
  GDALRegister_GTiff();
  GDALRegister_VRT();
  GDALRegister_AAIGrid();
  GDALRegister_SRTMHGT();
  RegisterOGRGPX();
  RegisterOGRGeoJSON();
  GDALSetCacheMax64(kCacheBytes);
  OSRSetPROJEnableNetwork(0);
}

void CPL_STDCALL keep_first_error(CPLErr severity, CPLErrorNum, const char* message) {
  std::string& error = *static_cast<std::string*>(CPLGetErrorHandlerUserData());
  if (severity < CE_Failure || !error.empty()) return;
  error = message;
  for (char& c : error) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
}

}  // namespace

GdalSession::GdalSession() {
  static std::once_flag registered;
  CPLPushErrorHandlerEx(keep_first_error, &error_);
  for (const Setting& setting : kSettings) CPLSetThreadLocalConfigOption(setting.name, setting.value);
  std::call_once(registered, register_drivers);
}

GdalSession::~GdalSession() {
  CPLPopErrorHandler();
}

std::string GdalSession::take_error() {
  return std::exchange(error_, {});
}

const char* const* raster_drivers() {
  static constexpr std::array<const char*, 5> kDrivers{"GTiff", "AAIGrid", "SRTMHGT", "VRT", nullptr};
  return kDrivers.data();
}

const char* const* track_drivers() {
  static constexpr std::array<const char*, 3> kDrivers{"GPX", "GeoJSON", nullptr};
  return kDrivers.data();
}

}  // namespace prairie
