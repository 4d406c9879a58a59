#include "agents/utm.h"

#include <GeographicLib/TransverseMercator.hpp>
#include <GeographicLib/UTMUPS.hpp>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "maps/georaster/spatial_reference.h"

namespace prairie {
namespace {

constexpr int kZones = 60;
constexpr int kEpsgNorth = 32600, kEpsgSouth = 32700;  // plus the number of the zone
constexpr double kFalseEastingM = 500'000.0, kFalseNorthingM = 10'000'000.0;

double meridian_deg(const UtmZone& zone) {
  return 6.0 * zone.number - 183.0;
}

}  // namespace

std::optional<UtmZone> utm_zone_of(const GeoReference& reference) {
  const std::optional<SpatialReference> system = SpatialReference::of_wkt(reference.wkt);
  const int code = system ? system->epsg().value_or(0) : 0;
  if (code > kEpsgNorth && code <= kEpsgNorth + kZones) return UtmZone{code - kEpsgNorth, true};
  if (code > kEpsgSouth && code <= kEpsgSouth + kZones) return UtmZone{code - kEpsgSouth, false};
  return std::nullopt;
}

std::optional<UtmFrame> utm_frame_of(const GeoReference& reference) {
  const std::optional<UtmZone> zone = utm_zone_of(reference);
  if (!zone) return std::nullopt;
  return UtmFrame{*zone, {reference.west_m, reference.south_m}};
}

UtmZone standard_utm_zone(GeoPoint point) {
  assert(point.latitude_deg >= kLeastUtmLatitudeDeg && point.latitude_deg <= kMostUtmLatitudeDeg);
  using GeographicLib::UTMUPS;
  return {UTMUPS::StandardZone(point.latitude_deg, point.longitude_deg, UTMUPS::UTM),
          point.latitude_deg >= 0.0};
}

double degrees_from_meridian(const UtmZone& zone, GeoPoint point) {
  return std::remainder(point.longitude_deg - meridian_deg(zone), 360.0);
}

glm::dvec2 utm_m(const UtmZone& zone, GeoPoint point) {
  assert(std::abs(degrees_from_meridian(zone, point)) <= kMostDegreesFromMeridian);
  glm::dvec2 at_m;
  GeographicLib::TransverseMercator::UTM().Forward(meridian_deg(zone), point.latitude_deg,
                                                   point.longitude_deg, at_m.x, at_m.y);
  return at_m + glm::dvec2(kFalseEastingM, zone.north ? 0.0 : kFalseNorthingM);
}

}  // namespace prairie
