#include "maps/georaster/spatial_reference.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "maps/georaster/gdal_session.h"

namespace prairie {
namespace {

OGRSpatialReferenceH handle_of(const SpatialReference& reference) {
  return reference.handle();
}

/// 1…60; Svalbard and the coast of Norway have zones of their own width.
int utm_zone_at(double longitude_deg, double latitude_deg) {
  if (latitude_deg >= 56.0 && latitude_deg < 64.0 && longitude_deg >= 3.0 && longitude_deg < 12.0) return 32;
  if (latitude_deg >= 72.0 && longitude_deg >= 0.0 && longitude_deg < 42.0)
    return longitude_deg < 9.0 ? 31 : longitude_deg < 21.0 ? 33 : longitude_deg < 33.0 ? 35 : 37;
  const double wrapped_deg = longitude_deg - 360.0 * std::floor((longitude_deg + 180.0) / 360.0);
  return std::clamp(static_cast<int>(std::floor((wrapped_deg + 180.0) / 6.0)) + 1, 1, 60);
}

}  // namespace

SpatialReference::SpatialReference(void* handle)
    : handle_(handle, [](void* h) { OSRDestroySpatialReference(h); }) {
  OSRSetAxisMappingStrategy(handle, OAMS_TRADITIONAL_GIS_ORDER);
}

std::optional<SpatialReference> SpatialReference::of_wkt(const std::string& wkt) {
  if (wkt.empty()) return std::nullopt;
  GdalSession session;
  SpatialReference reference(OSRNewSpatialReference(nullptr));
  // GDAL takes the characters as its own to change, and leaves them as they are.
  std::string text = wkt;
  char* characters = text.data();
  if (OSRImportFromWkt(handle_of(reference), &characters) != OGRERR_NONE) return std::nullopt;
  return reference;
}

std::optional<SpatialReference> SpatialReference::of_name(const std::string& name) {
  GdalSession session;
  constexpr std::string_view kEpsg = "EPSG:";
  SpatialReference reference(OSRNewSpatialReference(nullptr));
  if (name.starts_with(kEpsg)) {
    // A plane's number, or "plane+heights".
    const bool is_number = name.find_first_not_of("0123456789+", kEpsg.size()) == std::string::npos;
    if (!is_number || OSRSetFromUserInput(handle_of(reference), name.c_str()) != OGRERR_NONE)
      return std::nullopt;
    return reference;
  }
  if (name.starts_with("+proj=")) {
    if (OSRImportFromProj4(handle_of(reference), name.c_str()) != OGRERR_NONE) return std::nullopt;
    return reference;
  }
  return of_wkt(name);
}

SpatialReference SpatialReference::wgs84() {
  GdalSession session;
  SpatialReference reference(OSRNewSpatialReference(nullptr));
  OSRImportFromEPSG(handle_of(reference), 4326);
  return reference;
}

SpatialReference SpatialReference::utm_at(glm::dvec2 longitude_latitude_deg) {
  GdalSession session;
  SpatialReference reference(OSRNewSpatialReference(nullptr));
  const int zone = utm_zone_at(longitude_latitude_deg.x, longitude_latitude_deg.y);
  OSRImportFromEPSG(handle_of(reference), (longitude_latitude_deg.y < 0.0 ? 32700 : 32600) + zone);
  return reference;
}

std::string SpatialReference::wkt() const {
  GdalSession session;
  constexpr const char* kOptions[] = {"FORMAT=WKT2_2019", nullptr};
  char* text = nullptr;
  std::string result;
  if (OSRExportToWktEx(handle_of(*this), &text, kOptions) == OGRERR_NONE && text != nullptr) result = text;
  CPLFree(text);
  return result;
}

std::string SpatialReference::name() const {
  const char* name = OSRGetName(handle_of(*this));
  const char* authority = OSRGetAuthorityName(handle_of(*this), nullptr);
  const char* code = OSRGetAuthorityCode(handle_of(*this), nullptr);
  const std::string known = name != nullptr && *name != '\0' ? name : "an unnamed coordinate system";
  if (authority == nullptr || code == nullptr) return known;
  return fmt::format("{} ({}:{})", known, authority, code);
}

std::optional<int> SpatialReference::epsg() const {
  const char* authority = OSRGetAuthorityName(handle_of(*this), nullptr);
  const char* code = OSRGetAuthorityCode(handle_of(*this), nullptr);
  if (authority != nullptr && code != nullptr)
    return std::string_view(authority) == "EPSG" ? std::optional(std::atoi(code)) : std::nullopt;
  return utm_code();
}

std::optional<int> SpatialReference::utm_code() const {
  GdalSession session;
  int is_north = 0;
  const int zone = OSRGetUTMZone(handle_of(*this), &is_north);
  if (zone == 0) return std::nullopt;
  const int code = (is_north != 0 ? 32600 : 32700) + zone;
  SpatialReference utm(OSRNewSpatialReference(nullptr));
  OSRImportFromEPSG(handle_of(utm), code);
  return has_plane_of(utm) ? std::optional(code) : std::nullopt;
}

bool SpatialReference::is_geographic() const {
  return OSRIsGeographic(handle_of(*this)) != 0 && OSRIsProjected(handle_of(*this)) == 0;
}

bool SpatialReference::is_on_earth() const {
  return OSRIsGeographic(handle_of(*this)) != 0 || OSRIsProjected(handle_of(*this)) != 0;
}

double SpatialReference::metres_per_unit() const {
  if (is_geographic()) return 1.0;
  char* name = nullptr;
  return OSRGetLinearUnits(handle_of(*this), &name);
}

std::optional<double> SpatialReference::vertical_metres_per_unit() const {
  if (OSRIsCompound(handle_of(*this)) == 0 && OSRIsVertical(handle_of(*this)) == 0) return std::nullopt;
  char* name = nullptr;
  return OSRGetTargetLinearUnits(handle_of(*this), "VERT_CS", &name);
}

bool SpatialReference::has_plane_of(const SpatialReference& other) const {
  GdalSession session;
  const auto plane_of = [](const SpatialReference& reference) {
    SpatialReference plane(OSRClone(handle_of(reference)));
    OSRDemoteTo2D(handle_of(plane), nullptr);
    if (OSRIsCompound(handle_of(plane)) != 0) OSRStripVertical(handle_of(plane));
    return plane;
  };
  constexpr const char* kOptions[] = {"IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES", "CRITERION=EQUIVALENT",
                                      "IGNORE_COORDINATE_EPOCH=YES", nullptr};
  return OSRIsSameEx(handle_of(plane_of(*this)), handle_of(plane_of(other)), kOptions) != 0;
}

PlaceTransform::PlaceTransform(const SpatialReference& from, const SpatialReference& to) {
  GdalSession session;
  handle_ = std::shared_ptr<void>(OCTNewCoordinateTransformation(handle_of(from), handle_of(to)),
                                  [](void* h) { OCTDestroyCoordinateTransformation(h); });
}

bool PlaceTransform::apply(std::span<glm::dvec2> places) const {
  if (handle_ == nullptr) return false;
  GdalSession session;
  std::vector<double> x(places.size()), y(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    x[k] = places[k].x;
    y[k] = places[k].y;
  }
  if (OCTTransform(handle_.get(), static_cast<int>(places.size()), x.data(), y.data(), nullptr) == 0)
    return false;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!std::isfinite(x[k]) || !std::isfinite(y[k])) return false;
    places[k] = {x[k], y[k]};
  }
  return true;
}

}  // namespace prairie
