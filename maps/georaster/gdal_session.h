// GDAL as this program lets it work: a short list of drivers, no plug-ins, no network, no Python in a VRT,
// and its messages kept instead of printed.
#pragma once

#include <string>

namespace prairie {

/// While one lives, GDAL's calls in this thread follow these rules. They nest.
class GdalSession {
 public:
  GdalSession();
  ~GdalSession();
  GdalSession(const GdalSession&) = delete;
  GdalSession& operator=(const GdalSession&) = delete;

  /// The first error since the last call, one line; empty if there was none.
  std::string take_error();

 private:
  std::string error_;
};

/// The drivers that rasters are opened with, as GDALOpenEx wants them.
const char* const* raster_drivers();

/// Those that tracks are opened with.
const char* const* track_drivers();

}  // namespace prairie
